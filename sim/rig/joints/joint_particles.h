#pragma once

#include <vector>

#include "sim/rig/actor.h"

namespace knuckle {

/// The particles of an actor while its joints are made: some become shared, some give way to shared ones.
struct ParticleDraft {
    Vector3f position{0, 0, 0};
    float signedDistance = 0.0f;
    std::vector<uint32_t> bodies = {};  ///< Empty once it has given way.
    bool locked = false;                ///< Belongs to a joint and must not change.
    Vector3f outward{0, 0, 0};          ///< Zero in joints, which have no unique direction out.
};

struct JointPlan {
    JointType type = JointType::Ball;
    uint32_t parent = 0, child = 0;  ///< Bodies.
    Vector3f anchor{0, 0, 0};
    Vector3f axis{0, 0, 1};        ///< Unit.
    Vector3f along{0, -1, 0};      ///< Unit, from the joint down the child.
    Vector3f flexion{0, 0, 0};     ///< Unit, direction in which the child's end swings as it bends; 0 if unknown.
    Vector3f twistAxis{0, -1, 0};  ///< Unit, of a ball's child.
    JointLimits limits = {};
    JointStrength strength = {};
    bool clear = true;  ///< Make room to turn in.

    /// Takes another axis, unit, whose bending direction is unknown.
    void turnAbout(const Vector3f& other);
};

/// Makes the particles that the two bodies share and removes those in their way. A universal joint needs `crossBody`,
/// the body in between. @returns the shared particles: ball 1, hinge 2-5 in a row on the axis, stiff 4, universal the
/// two shared with the parent, then the two shared with the child.
std::vector<uint32_t> makeJointParticles(std::vector<ParticleDraft>& particles, const JointPlan& plan, float diameter,
                                         uint32_t crossBody);

}  // namespace knuckle
