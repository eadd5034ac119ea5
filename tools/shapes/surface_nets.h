#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/actor/mesh/triangle_tree.h"
#include "tools/shapes/distance.h"

namespace knuckle {

/// The zero level of `distance` (negative inside) as a closed mesh, by surface nets (Gibson 1998): one vertex per
/// cell of side `step` that the surface crosses, then drawn onto the surface. `low` and `high` must enclose it.
TriangleMesh surfaceNets(const Distance& distance, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                         double step);

}  // namespace knuckle
