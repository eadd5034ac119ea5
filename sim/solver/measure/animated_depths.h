#pragma once

#include <string>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Where what clips move goes through something that it cannot push away.
struct AnimatedDepth {
    uint32_t object = 0;
    uint32_t other = NO_INDEX;  ///< Another animated object; none: a collider.
    uint32_t collider = NO_INDEX;
    float depth = 0.0f;  ///< The farthest that the surface of a particle is within it [m].
    float time = 0.0f;   ///< When [s].
};

/// Of each animated object, until any of it may be let go, the deepest in a collider, and in another animated object.
/// Looked for twenty times a second; what is less than a diameter deep is left out. @param duration [s].
std::vector<AnimatedDepth> animatedDepths(const World& world, float duration);

}  // namespace knuckle
