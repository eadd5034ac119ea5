#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"
#include "sim/rig/model_source.h"

namespace knuckle {

/// The nodes that become bones; in a file with several skeletons, those of the picked one. Several skeletons exist if
/// each has a mesh skinned to three of its bones or more, and no mesh is skinned to bones of two; in an export of a
/// run, everything besides a single figure is left out, too.
/// @throws SkeletonError if none is picked, or there is none of the name.
std::vector<uint32_t> pickSkeleton(const aiScene& scene, const ModelPick& pick, NodeTable& table,
                                   std::vector<std::string>& notes);

}  // namespace knuckle
