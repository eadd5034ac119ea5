#pragma once

#include <span>
#include <vector>

#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Which bones have bodies.
struct BoneCut {
    std::vector<std::vector<uint32_t>> particles;  ///< Per bone, into Voxels; empty without a body.
    std::vector<std::vector<uint32_t>> merged;     ///< Per bone, the bones with skin that joined it, including those
                                                   ///< merged into them.
};

/// Gives every limb its particles; limbs too small for a body join what they hang on, outer ones first. If nothing that
/// they hang on has a body, they join the nearest in the skeleton, of equally near ones that nearest in space.
/// @param bones per particle its limb.
BoneCut mergeSmall(const BoneTree& tree, std::span<const BoneAnatomy> anatomy, const Voxels& voxels,
                   const std::vector<uint32_t>& bones);

/// Gives every limb its particles as a plan says. @throws InputError for a body of it that is too small.
BoneCut mergePlanned(const Figure& figure, const Voxels& voxels, const std::vector<uint32_t>& bones,
                     const BodyPlan& plan);

}  // namespace knuckle
