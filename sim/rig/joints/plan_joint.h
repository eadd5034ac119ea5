#pragma once

#include <vector>

#include "sim/rig/actor_options.h"
#include "sim/rig/figure.h"
#include "sim/rig/joints/joint_particles.h"
#include "sim/rig/limbs/body_draft.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// A figure cut into bodies, between which joints are planned.
struct BodyCut {
    const Figure& figure;
    const std::vector<BodyDraft>& drafts;
    const Voxels& voxels;

    const BoneAnatomy& boneOf(uint32_t body) const { return figure.anatomy[drafts[body].bone]; }
};

/// The joint of a body with what it hangs on: as options say, else as its part of a body and clips do.
/// @throws InputError for a limit that is not one of the joint's type.
JointPlan planJoint(const BodyCut& cut, uint32_t body, const ArticulationOptions& options);

}  // namespace knuckle
