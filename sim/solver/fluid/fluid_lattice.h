#pragma once

#include <Eigen/Geometry>

#include "sim/world/world.h"

namespace knuckle {

/// How the cells of the fluids' grid are wrapped onto a line (shaders/sim/common/grid.glsl): as boxes of the scene's own
/// shape, so that fluid gets far before particles look near to each other that are not.
struct FluidLattice {
    Eigen::AlignedBox3f home;  ///< In it none do [m].
    uint32_t strideY = 0, strideZ = 0;
};

/// The box reaches from the particles to the planes and walls around them, and beyond as far as the cells suffice.
/// @param cell  Width of a cell [m], FINE_CELLS of them along x
/// @param cells  How many there are, a power of two of at least 4096
FluidLattice fluidLattice(const World& world, float cell, uint32_t cells);

}  // namespace knuckle
