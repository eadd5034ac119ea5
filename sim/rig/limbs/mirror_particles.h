#pragma once

#include <vector>

#include "sim/rig/anatomy/shape/mirror.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Where the solid is symmetric within half a particle's diameter, replaces the particles and bones on the negative
/// side of the plane by images of those of the other side.
/// @param bones per particle.
/// @param parents of bones: particles on the plane belong to an adjacent bone on the plane; elsewhere, those between
/// two bones that mirror each other are left out.
void mirrorParticles(const Solid& solid, const Mirror& mirror, const std::vector<int32_t>& parents, Voxels& voxels,
                     std::vector<uint32_t>& bones);

}  // namespace knuckle
