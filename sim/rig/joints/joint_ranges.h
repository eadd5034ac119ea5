#pragma once

#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/joints/joint_particles.h"

namespace knuckle {

/// How a limb stands at its joint in the rest pose.
struct LimbStance {
    BodyPart part = BodyPart::Other;
    Vector3f above{0, 0, 0};    ///< Unit, from the joint above to this one; 0 where nothing is known of it.
    Vector3f along{0, -1, 0};   ///< Unit, from the joint down the limb.
    Vector3f forward{0, 0, 1};  ///< Unit, where the figure looks.
    Vector3f outward{1, 0, 0};  ///< Unit, to the limb's own side.
    float bend = 0.0f;          ///< Of a hinge: how far it is bent the way that it bends [rad].
    uint32_t segments = 1;      ///< Of a spine or a neck: how many joints share its range.
    bool upright = true;        ///< Of a figure on two legs; else a creature's.
};

/// Whether a joint has a range of its own, as a ball with limits or a hinge.
bool hasRange(BodyPart part);

/// The joint's type where it has limits: a spine then is a row of balls that give a little.
JointType rangedType(BodyPart part);

/// The ordinary range of motion of a human joint (American Academy of Orthopaedic Surgeons, 1965), which takes in
/// the rest pose with 5 degrees to spare; a tail's gives a little at each bone. A creature's legs swing about where
/// they are at rest, and their knees go half of the way to straight. None for other parts.
JointLimits ordinaryRange(const LimbStance& stance);

/// The range of a hinge of which only clips are known: what they do and 20 degrees more, none where they turn it beyond
/// 175 degrees from rest.
JointLimits rangeInClips(const Vector3f& axis, std::span<const std::vector<Quaternionf>> clips);

/// Locks what has a range of less than 5 degrees about the rest pose: a hinge and a ball become stiff, a ball that only
/// twists and a universal joint with one axis left become hinges. Limits behind a spring stay as they are.
void lockNarrowRanges(JointPlan& plan);

/// Makes a ball's cone the smallest one around it and all that a clip does, with 5 degrees to spare: it leans to where
/// the clip goes.
void leanTo(JointLimits& limits, const Vector3f& axis, std::span<const Quaternionf> turns);

/// Widens limits so that they take in every turn of a clip with 5 degrees to spare, 175 degrees at most. A hinge that
/// goes round in it, and a ball whose axis does, has none any more.
/// @param turns of the child against its parent, key by key.
/// @param axis the joint's, in the rest pose.
void takeIn(JointLimits& limits, JointType type, const Vector3f& axis, std::span<const Quaternionf> turns);

}  // namespace knuckle
