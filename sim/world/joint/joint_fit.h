#pragma once

#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// How two bodies meet at particles that they share.
struct JointFit {
    JointType type = JointType::Ball;
    JointSide body, parent;
};

/// How far particles let a body turn against another follows from their arrangement: one place makes a ball, a line a
/// hinge about itself, a face holds all turns.
/// @param axis for limits, the body's axis in the rest pose, and `cone` the middle of the other's cone: unit; else 0.
/// Both, and all that follows, in the body's axes. @param turn at rest, from the body's axes to the parent's.
JointFit fitJoint(const World& world, uint32_t body, uint32_t parent, const std::vector<uint32_t>& particles,
                  const Vector3f& axis, const Vector3f& cone, const Quaternionf& turn);

/// The same for a recorded joint, seen from one of its bodies, at some of its particles.
JointFit fitJoint(const World& world, const Joint& joint, uint32_t body, const std::vector<uint32_t>& particles);

}  // namespace knuckle
