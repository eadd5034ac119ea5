#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"
#include "sim/rig/model_source.h"

namespace knuckle {

/// The nodes that become bones: of a file with several skeletons those of the one that is picked.
/// Several skeletons are what has a mesh each, skinned to three of its bones or more, where no mesh is skinned to
/// bones of two; in an export of a run what else stands beside a single figure is left out, too.
/// @throws SkeletonError where that is not said, or where there is none of the name.
std::vector<uint32_t> pickSkeleton(const aiScene& scene, const ModelPick& pick, NodeTable& table,
                                   std::vector<std::string>& notes);

}  // namespace knuckle
