#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// Fills what is kept per mover (body or loose particle), and the order of particles in contact lists.
void uploadMovers(SolverBuffers& out, const World& world);
/// Fills what is kept per assembly about its sleep: all are awake.
void uploadSleep(SolverBuffers& out);

}  // namespace knuckle
