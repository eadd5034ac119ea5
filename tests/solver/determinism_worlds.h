#pragma once

#include <string>
#include <vector>

#include "sim/world/builder/builder.h"

namespace knuckle::test {

/// A builder with ground on which things sleep.
WorldBuilder sleepyBuilder();

/// Small worlds in which something of one kind happens within a second.
World softWorld();   ///< Plastic jelly and a rigid box that fall on each other.
World ropeWorld();   ///< Boxes that fall into a cloth that tears, one on a rope.
World fluidWorld();  ///< Heavy boxes that fall between walls through two fluids, one above the other.
/// Two jets into each other over boxes, of which one waits and one reuses its oldest particles, and fluid that drains.
World emitterWorld();
World heldWorld();                ///< Chains that are held and let go one after another, on ground on which they sleep.
World animatedWorld();            ///< Chains that dance among boxes, from clip to clip, and are let go in all ways.
World drivenWorld();              ///< The same, driven from then on.
World limitedWorld();             ///< Joints at their limits, rigid and soft, and chains of which some tear.
World bouncyWorld();              ///< Collisions that bounce.
World sleepyWorld(float freeze);  ///< Towers that sleep, or freeze, until something falls on them.
World mechanismWorld();  ///< Motors, springs, a gear, on joints that meet limits and boxes, and one that tears.
World movingWorld();     ///< A piston, a lift and a drum among towers that sleep, bouncy boxes and water.
World towerWorld();      ///< A tower of eight on a fixed block, and what strikes it.
World roundWorld();      ///< Balls and capsules.
World gridWorld();       ///< A mesh and a heightfield, and what falls on them.
World windyWorld();      ///< Cloth, boxes and a fluid in gusts, with an explosion.
World everyWorld(GridKind grid);  ///< All of that together.

/// One kind of matter by its name.
struct Matter {
    std::string name;
    World (*world)();
};
/// All kinds, and pairs of the bench by both solvers.
std::vector<Matter> matters();

}  // namespace knuckle::test
