#pragma once

#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// A clip that moves over the ground as its feet do.
struct TravelClip {
    BodyClip clip;
    float speed = 0.0f;  ///< Its mean speed over a round at the clip's own pace [m/s].
};

/// Moves a figure over the ground so that what touches the ground stands still; heights and turns stay. A clip that
/// moves already stays as it is, except that its feet no longer slide. While no foot is down it keeps its speed.
/// @throws InputError if it never touches the ground in motion, so that its feet give no speed.
TravelClip travelOnFeet(const Actor& actor, const BodyClip& clip);

/// The same along a path: the clip is played round after round, and turns about the standing foot towards the path.
/// Beyond its end it goes straight on.
/// @param path points over the ground (x, z), from the pivot's place on, in the object's frame [m]; at least one.
/// @param start in the clip, where it begins [s]. @param duration of the new clip [s].
TravelClip travelAlong(const Actor& actor, const BodyClip& clip, const std::vector<Eigen::Vector2f>& path, float start,
                       float duration);

}  // namespace knuckle
