#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Fills NodeTable::apart: where meshes are skinned to a figure, those that hang on no bone and are not within its
/// bounds, as floors are.
void leaveApart(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes);

}  // namespace knuckle
