#pragma once

#include <Eigen/Geometry>

#include "sim/world/world.h"

namespace knuckle {

/// Bounds of all particles as spheres [m]; empty if there are none.
Eigen::AlignedBox3f particleBounds(const World& world);
/// Bounds of a collider that has an end: any except a plane [m].
Eigen::AlignedBox3f colliderBounds(const World& world, const Collider& collider);

}  // namespace knuckle
