#pragma once

#include "sim/world/animation/animation.h"

namespace knuckle {

/// Between which keys of a clip a moment is.
struct ClipTime {
    uint32_t key = 0;     ///< At or before it.
    float part = 0.0f;    ///< Of the way to the next, 0 ... 1.
    uint32_t rounds = 0;  ///< That it was played through before.
};

/// @param time since the start of the simulation [s], not before the play's.
ClipTime clipTime(const BodyClip& clip, const ClipPlay& play, double time);

/// The spline of Catmull and Rom through the keys; before the first and behind the last key they go on straight.
Vector3f sampleRoot(const BodyClip& clip, const ClipTime& at);
Quaternionf sampleTurn(const BodyClip& clip, const ClipTime& at, uint32_t body);

/// The turn that is a part of the way from one to another.
Quaternionf mixed(const Quaternionf& from, const Quaternionf& to, float part);

}  // namespace knuckle
