#pragma once

#include <string>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// An animated object that passes through something it cannot push away.
struct AnimatedDepth {
    uint32_t object = 0;
    uint32_t other = NO_INDEX;  ///< Another animated object; none: a collider.
    uint32_t collider = NO_INDEX;
    float depth = 0.0f;  ///< The farthest that a particle's surface is inside the other [m].
    float time = 0.0f;   ///< When [s].
};

/// Per animated object, its deepest overlap with a collider and with another animated object, until any of it may be
/// let go. Checked twenty times a second; overlaps below a diameter are left out. @param duration [s].
std::vector<AnimatedDepth> animatedDepths(const World& world, float duration);

}  // namespace knuckle
