#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// The numbers of fluids; the rest of the parameters must be set.
void setFluidParameters(gpu::StepParameters& parameters, const World& world);
/// Makes the buffers of fluids, next to nothing where there are none.
/// @throws DeviceError when the device's limits are too small.
void makeFluid(SolverBuffers& out, const World& world, const Gpu& gpu);
void addFluid(BufferTable& table, FluidBuffers& fluid);

/// Of the last substep, of each fluid particle over its density at rest, in no order that matters. Stalls.
std::vector<float> fluidDensities(SolverBuffers& buffers);

}  // namespace knuckle
