#pragma once

#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/joints/joint_particles.h"

namespace knuckle {

/// How a limb stands at its joint in the rest pose.
struct LimbStance {
    BodyPart part = BodyPart::Other;
    Vector3f above{0, 0, 0};    ///< Unit, from the joint above to this one; 0 if that is unknown.
    Vector3f along{0, -1, 0};   ///< Unit, from the joint down the limb.
    Vector3f forward{0, 0, 1};  ///< Unit, the direction that the figure faces.
    Vector3f outward{1, 0, 0};  ///< Unit, to the limb's own side.
    float bend = 0.0f;          ///< For a hinge: how far it is bent in its bending direction [rad].
    uint32_t segments = 1;      ///< For a spine or a neck: number of joints that share its range.
    bool upright = true;        ///< Belongs to a figure on two legs; else to a creature.
};

/// Whether a joint has a range of its own, as a ball with limits or a hinge.
bool hasRange(BodyPart part);

/// The joint's type if it has limits: a spine then is a row of balls that give a little.
JointType rangedType(BodyPart part);

/// The ordinary range of motion of a human joint (American Academy of Orthopaedic Surgeons, 1965), widened to include
/// the rest pose with 5 degrees to spare; a tail's gives a little at each bone. A creature's legs swing about their
/// places at rest, and its knees stretch half way to straight. None for other parts.
JointLimits ordinaryRange(const LimbStance& stance);

/// The range of a hinge known only from clips: what they do and 20 degrees more, none if they turn it more than 175
/// degrees from rest.
JointLimits rangeInClips(const Vector3f& axis, std::span<const std::vector<Quaternionf>> clips);

/// Locks joints with a range of less than 5 degrees about the rest pose: a hinge and a ball become stiff, a ball that
/// only twists and a universal joint with one axis left become hinges. Limits with a spring stay as they are.
void lockNarrowRanges(JointPlan& plan);

/// Makes a ball's cone the smallest one around it and all turns of a clip, with 5 degrees to spare: it leans to where
/// the clip goes.
void leanTo(JointLimits& limits, const Vector3f& axis, std::span<const Quaternionf> turns);

/// Widens limits to include every turn of a clip with 5 degrees to spare, up to 175 degrees. A hinge that goes round in
/// it, or a ball whose axis does, loses its limit.
/// @param turns of the child against its parent, key by key.
/// @param axis the joint's, in the rest pose.
void takeIn(JointLimits& limits, JointType type, const Vector3f& axis, std::span<const Quaternionf> turns);

}  // namespace knuckle
