#pragma once

#include <Eigen/Geometry>

#include "sim/world/world.h"

namespace knuckle {

/// How the cells of the fluids' grid are wrapped onto a line (shaders/sim/common/grid/grid.glsl). Cells that are a box
/// of this shape apart share an index, so particles in them look near to each other. The box has the shape of the
/// scene, so that fluid must spread far before that happens.
struct FluidLattice {
    Eigen::AlignedBox3f home;  ///< Within it, no two cells share an index [m].
    uint32_t strideY = 0, strideZ = 0;
};

/// The box reaches from the particles to the planes and walls around them, and beyond as far as the cells suffice.
/// @param cell  Width of a cell [m], FINE_CELLS of them along x
/// @param cells  How many there are, a power of two of at least 4096
FluidLattice fluidLattice(const World& world, float cell, uint32_t cells);

}  // namespace knuckle
