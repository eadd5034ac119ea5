#pragma once

#include "sim/world/animation/animation.h"

namespace knuckle {

/// The keys of a clip around a moment.
struct ClipTime {
    uint32_t key = 0;     ///< At or before the moment.
    float part = 0.0f;    ///< Of the way to the next key, 0 ... 1.
    uint32_t rounds = 0;  ///< Completed rounds before it.
};

/// @param time since the start of the simulation [s], not before the play's.
ClipTime clipTime(const BodyClip& clip, const ClipPlay& play, double time);

/// Catmull-Rom spline through the keys; continues straight before the first and beyond the last key.
Vector3f sampleRoot(const BodyClip& clip, const ClipTime& at);
Quaternionf sampleTurn(const BodyClip& clip, const ClipTime& at, uint32_t body);

/// The turn at a part of the way from one to another.
Quaternionf mixed(const Quaternionf& from, const Quaternionf& to, float part);

}  // namespace knuckle
