#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/world/builder/body_builder.h"

namespace knuckle {

/// How the two bodies of a joint meet. All positions in the frame in which the bodies were added (the rest pose).
struct JointSpec {
    JointType type = JointType::Ball;
    std::string name;
    Vector3f anchor{0, 0, 0};  ///< Place of the joint [m].
    Vector3f axis{0, 0, 1};    ///< Hinge: its axis. Universal: the axis of the hinge at the parent.
    Vector3f along{1, 0, 0};   ///< From parent to child; made perpendicular to axis if it is not.
    /// Hinge: the side of the plane of axis and `along` that limiting particles block: +1 (the side of along x axis),
    /// -1 (the other) or 0 (none).
    int limitSide = 0;
    JointLimits limits;
    JointStrength strength;
    TurnDrive drive;      ///< Of both hinges of a universal joint.
    bool geared = false;  ///< Hinge: whether addGear() will name it.
};

/// Joints between bodies, by sharing particles (paper, section 4).
class JointBuilder : public BodyBuilder {
public:
    /// Joins two bodies by particles that both share. Particles of either within half a diameter of a required place
    /// become shared ones; elsewhere new particles are made.
    void addJoint(uint32_t parent, uint32_t child, const JointSpec& spec);
    /// Joins two bodies of any objects, which are complete; the spec is in the world's frame, and its axes hold as the
    /// bodies stand. All of the joint's particles are new, and but for those of a universal joint they weigh next to
    /// nothing. @param parent NO_INDEX: the world. What the joint adds is an object of its name. @returns the parent.
    uint32_t joinPlaced(uint32_t parent, uint32_t child, const JointSpec& spec);
    /// Couples two hinges that are geared (JointSpec); their bodies then form one assembly, so that wheels that mesh do
    /// not touch. @param ratio turns of the second per turn of the first, not 0.
    void addGear(const std::string& name, const HingeBodies& first, const HingeBodies& second, float ratio);
    /// Makes an existing particle part of one more body: the paper's joint itself.
    void shareParticle(uint32_t particle, uint32_t body);
    /// Describes a joint that shareParticle() makes; build() finds its particles and frames.
    void describeJoint(JointDraft draft);

private:
    uint32_t findOrCreate(const Vector3f& position, uint32_t bodyA, uint32_t bodyB);
    void shareAt(std::span<const Vector3f> places, uint32_t bodyA, uint32_t bodyB);
    void sharePlaced(uint32_t particle, uint32_t body);
    void describePlaced(uint32_t parent, uint32_t child, const JointSpec& spec, const JointLimits& limits,
                        const Vector3f& axis);
    void addUniversal(uint32_t parent, uint32_t child, const JointSpec& spec);
};

}  // namespace knuckle
