#pragma once

#include <vector>

#include "sim/rig/figure.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// The fewest particles along a rod: those that can span space.
inline constexpr int ROD_PARTICLES = 4;

/// Makes bodies of limbs so thin that they have none on the grid: one particle per diameter along their bones, wound
/// about them, since a straight row cannot turn about itself. Shorter limbs stay as they are. @param bones per particle
/// its limb.
void windRods(const Figure& figure, const Solid& solid, Voxels& voxels, std::vector<uint32_t>& bones);

}  // namespace knuckle
