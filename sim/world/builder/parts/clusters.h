#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Particles along an edge of a cluster: with fewer it could not detect bending. Neighbours share a layer.
inline constexpr uint32_t CLUSTER_SIZE = 3;

/// Overlapping pieces of a body: boxes of `size` particles an edge that share a layer with their neighbours, each cut
/// into connected parts (gaps below 1.8 diameters), so that limbs close to each other are not glued. Every particle
/// with a neighbour is in a cluster, and clusters connect all that is connected.
/// @param positions at rest [m]. @param size >= 2. @returns indices of particles, in increasing order.
std::vector<std::vector<uint32_t>> makeClusters(std::span<const Vector3f> positions, float diameter,
                                                uint32_t size = CLUSTER_SIZE);

/// Gives each soft body of the world its assembly, its clusters and their links (builder, after assemblies).
void makeSoftLinks(World& world);

}  // namespace knuckle
