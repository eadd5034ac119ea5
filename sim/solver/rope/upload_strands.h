#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// Uploads ropes and cloth: strands in phases, of which none has two strands with a particle in common, so that each
/// may move its particles in place. Call after uploadMovers().
void uploadStrands(SolverBuffers& out, const World& world);

/// Per distance of all strands of the World, in its order, whether it is torn. Waits for the GPU.
std::vector<bool> tornDistances(const SolverBuffers& buffers, const World& world);

}  // namespace knuckle
