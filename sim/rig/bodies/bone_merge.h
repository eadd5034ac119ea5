#pragma once

#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Which bones have bodies.
struct BoneCut {
    std::vector<std::vector<uint32_t>> particles;  ///< Per bone, into Voxels; empty without a body.
    std::vector<std::vector<uint32_t>> merged;     ///< Per bone, those with skin that joined it, with all of theirs.
};

/// Gives every limb its particles; those too small for a body join what they hang on, outer ones first, and where
/// nothing that they hang on has a body, the nearest in the skeleton, of equally near ones that nearest in space.
/// @param bones per particle its limb.
BoneCut mergeSmall(const BoneTree& tree, std::span<const BoneAnatomy> anatomy, const Voxels& voxels,
                   const std::vector<uint32_t>& bones);

}  // namespace knuckle
