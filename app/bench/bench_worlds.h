#pragma once

#include "sim/world/builder/builder.h"

namespace knuckle {

/// The world of the paper's table 2: `objectCount` objects of two 3x3x3 cubes (particle diameter 0.1 m) with one joint,
/// the four types in turn, in layers of 5 x 10 objects 0.4 m apart above the floor of a 4 x 4 m box with walls.
World table2World(uint32_t objectCount, const Settings& settings = {});
/// The same in layers of columns x 2 columns objects, in a box that is wider by as much.
World pairsWorld(uint32_t objectCount, uint32_t columns, const Settings& settings = {});
/// Particles of an object.
inline constexpr double PAIR_PARTICLES = 57.75;

/// Where the k-th of `count` in a row stands, in distances from the middle.
inline float fromMiddle(uint32_t k, uint32_t count)
{
    return static_cast<float>(k) - 0.5f * static_cast<float>(count - 1);
}

/// Floor and walls of that box.
void addBenchBox(WorldBuilder& builder);

/// A column of water in the left half of a box, which then breaks. @param counts of particles along x, y and z.
World damWorld(const Eigen::Vector3i& counts, const Settings& settings = {});
/// The same of sand.
World sandWorld(const Eigen::Vector3i& counts, const Settings& settings = {});

}  // namespace knuckle
