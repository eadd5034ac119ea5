#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// If nodes are in the pose of a clip's frame, puts bones into the pose in which meshes are bound to them
/// (NodeTable::globals), unless their bind matrices are no pose. Notes which pose it takes.
void takeBindPose(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes);

}  // namespace knuckle
