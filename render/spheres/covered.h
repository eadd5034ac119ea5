#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Whether any particles are not drawn, unseen ones or those that a skin or a shape is drawn instead of.
bool coversParticles(const World& world);

/// A bit per particle, 32 a word: set if it is unseen, or a skin or a shape is drawn instead of it.
std::vector<uint32_t> coveredParticles(const World& world);

}  // namespace knuckle
