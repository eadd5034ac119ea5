#pragma once

#include <Eigen/Geometry>

#include "sim/world/world.h"

namespace knuckle {

/// Around all particles as spheres [m]; empty where there are none.
Eigen::AlignedBox3f particleBounds(const World& world);
/// Around a collider that ends somewhere: any but a plane [m].
Eigen::AlignedBox3f colliderBounds(const World& world, const Collider& collider);

}  // namespace knuckle
