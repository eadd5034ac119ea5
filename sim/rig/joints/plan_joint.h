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

/// The joint between a body and what it hangs on: by options, else by its part of a body and by clips.
/// @throws InputError for a limit that the joint's type does not have.
JointPlan planJoint(const BodyCut& cut, uint32_t body, const ArticulationOptions& options);

}  // namespace knuckle
