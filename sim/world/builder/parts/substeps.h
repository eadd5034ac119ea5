#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace knuckle {

/// As many substeps a step that what may meet the cloth of a world stays within a fifth of a diameter in one: cloth is
/// light, and what is faster is through it before it can be stopped. 0 where there is no cloth, at most 64.
uint32_t clothSubsteps(const World& world);

/// As many that the iterations of a substep can follow the steepest pull of each pinned soft body, so that it is as
/// stiff as its material (docs/physics.md, soft bodies). 0 where there is none, at most 64. Free ones would lose
/// momentum to rounding.
uint32_t softSubsteps(const World& world);

}  // namespace knuckle
