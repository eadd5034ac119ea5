#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Particles along an edge of a cluster: with fewer it could not tell when it is bent. Neighbours share a layer.
inline constexpr uint32_t CLUSTER_SIZE = 3;

/// Overlapping pieces of a body: boxes of `size` particles an edge that share a layer with their neighbours, each cut
/// into parts that hang together (gaps below 1.8 diameters), so that limbs which are near are not glued. Every particle
/// that has a neighbour is in one, and what hangs together is held together.
/// @param positions at rest [m]. @param size >= 2. @returns indices of particles, in increasing order.
std::vector<std::vector<uint32_t>> makeClusters(std::span<const Vector3f> positions, float diameter,
                                                uint32_t size = CLUSTER_SIZE);

/// Gives each soft body of the world its assembly, its clusters and their links (builder, after assemblies).
void makeSoftLinks(World& world);

}  // namespace knuckle
