#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// Fills colliders and gridValues. @throws DeviceError when the device's limits are too small for the grids.
void uploadColliders(const Gpu& gpu, SolverBuffers& out, const World& world);

}  // namespace knuckle
