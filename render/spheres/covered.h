#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Whether a skin is drawn instead of any particles.
bool coversParticles(const World& world);

/// A bit per particle, 32 a word: set if a skin is drawn instead of it.
std::vector<uint32_t> coveredParticles(const World& world);

}  // namespace knuckle
