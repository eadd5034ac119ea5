#pragma once

#include <array>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/animation/animation.h"

namespace knuckle {

/// Pairs of an actor's bodies that lie in each other in more than half of a clip: limp, they would be pushed apart.
/// None that Actor::filtered or a joint with limits names already.
std::vector<std::array<uint32_t, 2>> overlapsIn(const Actor& actor, const BodyClip& clip);

}  // namespace knuckle
