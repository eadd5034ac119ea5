#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Fills NodeTable::apart if meshes are skinned to a figure: with meshes such as floors, which hang on no bone and are
/// not within the figure's bounds.
void leaveApart(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes);

}  // namespace knuckle
