#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// The buffers of emitters and drains, next to nothing where there are none. The colliders must be there.
void makePool(SolverBuffers& out, const World& world);
void addPool(BufferTable& table, PoolBuffers& pool);

/// Fluid particles that came from emitters and that left, since the start; those that are there now. Stalls.
struct FluidFigures {
    uint32_t emitted = 0, drained = 0, living = 0;
};
FluidFigures fluidFigures(const SolverBuffers& buffers);

}  // namespace knuckle
