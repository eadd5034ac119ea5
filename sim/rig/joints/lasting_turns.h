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
/// For limits that are only a guess.
inline constexpr Leeway GUESSED{HALF_TURN / 3, std::numeric_limits<float>::infinity()};

/// The turns of a joint in a clip for which its limits are widened.
struct LastingTurns {
    std::vector<Turns> parts;  ///< Parts of consecutive keys.
    float leftOut = 0.0f;      ///< Largest excess of the rest over the limits [rad]; 0: nothing is left out.
};

/// Leaves out turns where a hinge's bend, or a ball's cone or twist, exceeds the leeway for a moment for less than a
/// tenth of a second, or goes on to exceed the lasting leeway. The only key of a clip lasts.
/// @param type hinge or ball. @param rate of the turns [1/s].
LastingTurns lastingTurns(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns,
                          float rate, const Leeway& leeway = {});

/// Holds turns within limits, with LIMIT_SPARE to spare if these are wide enough; within a tenth of a second of held
/// turns they are smoothed, so that nothing stops abruptly.
Turns heldTurns(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns, float rate);

}  // namespace knuckle
