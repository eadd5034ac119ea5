#pragma once

#include <vector>

#include "sim/rig/anatomy/shape/mirror.h"
#include "sim/rig/mesh/voxelize.h"

namespace knuckle {

/// Where the solid is its own image within half a particle's diameter, gives the side of the plane that looks down its
/// normal the images of the other side's particles, and their bones.
/// @param bones per particle.
/// @param parents of bones: what lies on the plane belongs to a bone on it where this is next to it. What stands
/// between two bones that are images of each other is left out elsewhere.
void mirrorParticles(const Solid& solid, const Mirror& mirror, const std::vector<int32_t>& parents, Voxels& voxels,
                     std::vector<uint32_t>& bones);

}  // namespace knuckle
