#pragma once

#include "sim/world/world.h"

namespace knuckle {

/// The world as it stands where nothing but clips has moved anything until a time [s]: animated bodies and colliders
/// are where their clips have them then, at the speed there; all others are at their start.
World atTime(World world, double time);

}  // namespace knuckle
