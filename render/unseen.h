#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// A bit per particle, 32 a word: set for World::unseen.
std::vector<uint32_t> unseenBits(const World& world);

/// The box of all other particles [m]; empty if there are none.
Eigen::AlignedBox3f seenBounds(const World& world);

inline bool hasBit(const std::vector<uint32_t>& bits, size_t index)
{
    return (bits[index / 32] >> index % 32 & 1u) != 0;
}

}  // namespace knuckle
