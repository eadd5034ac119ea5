#pragma once

#include "sim/world/builder/builder.h"

namespace knuckle {

/// The world of the paper's table 2: `objectCount` objects of two 3x3x3 cubes (particle diameter 0.1 m) with one joint,
/// the four types in turn, in layers of 5 x 10 objects 0.4 m apart above the floor of a 4 x 4 m box with walls.
World table2World(uint32_t objectCount, const Settings& settings = {});

/// Floor and walls of that box.
void addBenchBox(WorldBuilder& builder);

}  // namespace knuckle
