#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "sim/actor/mesh/triangle_tree.h"

namespace knuckle {

/// The zero level of `distance` (negative inside) as a closed mesh, by surface nets (Gibson 1998): one vertex per
/// cell of side `step` that the surface crosses, then drawn onto the surface. `low` and `high` must enclose it.
TriangleMesh surfaceNets(const std::function<double(const Eigen::Vector3d&)>& distance, const Eigen::Vector3d& low,
                         const Eigen::Vector3d& high, double step);

}  // namespace knuckle
