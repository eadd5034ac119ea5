#pragma once

#include "sim/solver/buffers.h"

namespace knuckle {

/// Uploads ropes and cloth: strands in phases, of which none has two strands with a particle in common, so that each
/// may move its particles in place. Call after uploadMovers().
void uploadStrands(SolverBuffers& out, const World& world);

}  // namespace knuckle
