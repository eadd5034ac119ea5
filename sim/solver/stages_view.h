#pragma once

#include "sim/solver/measure/view_state.h"
#include "sim/solver/particle_view.h"
#include "sim/solver/stages.h"

namespace knuckle {

/// What pictures are drawn of: names of the stages' buffers.
ParticleView viewOf(const Stages& stages, const World& world);
/// The same read back. Stalls until the GPU is done.
ViewState readViewOf(const Stages& stages, const World& world);

}  // namespace knuckle
