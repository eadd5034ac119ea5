#pragma once

#include <array>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// Pairs of an actor's bodies that overlap in more than half of a clip: limp, they would be pushed apart. Without those
/// in Actor::filtered or at a joint with limits.
std::vector<std::array<uint32_t, 2>> overlapsIn(const Actor& actor, const BodyClip& clip);

}  // namespace knuckle
