#pragma once

#include "sim/solver/buffers.h"
#include "sim/solver/solver.h"

namespace knuckle {

/// The numbers of fluids; the rest of the parameters must be set.
void setFluidParameters(gpu::StepParameters& parameters, const World& world);
/// Makes the buffers of fluids, next to nothing where there are none.
/// @throws DeviceError when the device's limits are too small.
void makeFluid(SolverBuffers& out, const World& world, const Gpu& gpu);
void addFluid(BufferTable& table, FluidBuffers& fluid);

/// The part of the measures that is about fluids, by the densities of the last substep.
void measureFluids(Measures& out, SolverBuffers& buffers);

}  // namespace knuckle
