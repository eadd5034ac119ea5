#pragma once

#include <limits>
#include <vector>

#include "sim/base/angles.h"
#include "sim/rig/anatomy/clip_turns.h"
#include "sim/rig/joints/turn_parts.h"

namespace knuckle {

/// How far beyond its limits a joint may turn [rad].
struct Leeway {
    float moment = HALF_TURN / 9;   ///< For a moment.
    float lasting = HALF_TURN / 3;  ///< At all.
};
/// Where limits are but a guess.
inline constexpr Leeway GUESSED{HALF_TURN / 3, std::numeric_limits<float>::infinity()};

/// What of a joint's turns in a clip its limits are widened for.
struct LastingTurns {
    std::vector<Turns> parts;  ///< Keys that follow each other, part by part.
    float leftOut = 0.0f;      ///< How far beyond the limits the rest goes at most [rad]; 0: all of it lasts.
};

/// Leaves out where a hinge's bend, or a ball's cone or twist, is beyond what is allowed for a moment, for less than a
/// tenth of a second, and where it is on its way to beyond what is allowed at all. The only key of a clip lasts.
/// @param type hinge or ball. @param rate of the turns [1/s].
LastingTurns lastingTurns(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns,
                          float rate, const Leeway& leeway = {});

/// Holds turns within limits, with LIMIT_SPARE to spare where these are wide enough for it; within a tenth of a second
/// of what they held they are smoothed, so that nothing stops at once.
Turns heldTurns(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns, float rate);

}  // namespace knuckle
