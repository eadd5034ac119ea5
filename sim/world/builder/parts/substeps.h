#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace knuckle {

/// Substeps a step in which whatever may hit the cloth of a world moves at most a fifth of a diameter in one: cloth is
/// light, and anything faster passes through before it can be stopped. 0 without cloth, at most 64.
uint32_t clothSubsteps(const World& world);

}  // namespace knuckle
