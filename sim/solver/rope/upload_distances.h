#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// Uploads ropes and cloth: distanceRows in phases, of which none has two distanceRows with a particle in common, so that each
/// may move its particles in place. Call after uploadMovers().
void uploadDistances(SolverBuffers& out, const World& world);

/// Per distance of all distanceRows of the World, in its order, whether it is torn. Waits for the GPU.
std::vector<bool> tornDistances(const SolverBuffers& buffers, const World& world);

}  // namespace knuckle
