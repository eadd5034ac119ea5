#pragma once

#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// A clip that goes over the ground as its feet do.
struct TravelClip {
    BodyClip clip;
    float speed = 0.0f;  ///< That it goes with at its own pace, the mean of a round [m/s].
};

/// Moves a figure over the ground so that what of it touches the ground stands still; heights and turns stay. A clip
/// that goes already stays as it is, but for what its feet slide. While no foot is down it keeps its speed.
/// @throws InputError where it never touches the ground in motion, so that its feet say no speed.
TravelClip travelOnFeet(const Actor& actor, const BodyClip& clip);

/// The same along a path: the clip is played round after round, and turns about the foot that stands towards the path.
/// Behind its end it goes straight on.
/// @param path points over the ground (x, z), from the pivot's place on, in the object's frame [m]; at least one.
/// @param start in the clip, where it begins [s]. @param duration of the new clip [s].
TravelClip travelAlong(const Actor& actor, const BodyClip& clip, const std::vector<Eigen::Vector2f>& path, float start,
                       float duration);

}  // namespace knuckle
