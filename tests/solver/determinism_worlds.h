#pragma once

#include "sim/world/world.h"

namespace knuckle::test {

/// Small worlds in which something of one kind happens within a second.
World limitedWorld();             ///< Joints at their limits, rigid and soft, and chains of which some tear.
World bouncyWorld();              ///< Collisions that bounce.
World sleepyWorld(float freeze);  ///< Towers that sleep, or freeze, until something falls on them.
World roundWorld();               ///< Balls and capsules.
World gridWorld();                ///< A mesh and a heightfield, and what falls on them.
World everyWorld(GridKind grid);  ///< All of that together.

}  // namespace knuckle::test
