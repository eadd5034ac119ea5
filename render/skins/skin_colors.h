#pragma once

#include <cstdint>
#include <span>

#include "sim/world/world.h"

namespace knuckle {

/// Gives particles the colours of the skins that paint them: each gets that of the nearest vertex of its own body.
/// @param words of all particles, in the format of packColor().
void paintParticles(const World& world, std::span<uint32_t> words);

}  // namespace knuckle
