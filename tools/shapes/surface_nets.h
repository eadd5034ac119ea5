#pragma once

#include <Eigen/Core>
#include <functional>

#include "sim/rig/mesh/triangle_tree.h"
#include "tools/shapes/distance.h"

namespace knuckle {

/// A cube that is halved repeatedly; the middle plane of one side is x = 0, so that it has the symmetry of bodies.
struct NetGrid {
    Eigen::Vector3d centre{0, 0, 0};
    double finest = 0.002;  ///< Side of the smallest cell [m].
    int levels = 10;        ///< The cube's side is `finest` times two to the power of this.
    /// The largest size of a cell at a place [m].
    std::function<double(const Eigen::Vector3d&)> cellAt;
};

/// The zero level of a distance as a closed mesh, by surface nets (Gibson 1998) on an octree: one vertex per leaf that
/// the surface crosses, then moved onto the surface. The distance may exceed the true one by up to 12 mm, and be less
/// by any amount.
/// @throws std::logic_error if it exceeds it by more, or if the surface leaves the cube.
TriangleMesh surfaceNets(const Distance& distance, const NetGrid& grid);

/// The direction in which the distance grows, by differences over `h` [m]; not normalized.
Eigen::Vector3d gradient(const Distance& distance, const Eigen::Vector3d& p, double h);
/// The point of the surface directly below or above one close to it, rounded to 0.1 mm so that it does not depend on
/// the last bits of the mathematical library.
Eigen::Vector3d onSurface(const Distance& distance, const Eigen::Vector3d& p);

}  // namespace knuckle
