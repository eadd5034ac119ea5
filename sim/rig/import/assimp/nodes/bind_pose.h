#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Where nodes stand in a frame of a clip, gives bones the pose in which meshes are bound to them (NodeTable::globals),
/// unless their bind matrices are none. Which is a note.
void takeBindPose(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes);

}  // namespace knuckle
