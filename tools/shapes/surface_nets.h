#pragma once

#include <Eigen/Core>
#include <functional>

#include "sim/rig/mesh/triangle_tree.h"
#include "tools/shapes/distance.h"

namespace knuckle {

/// A cube cut in halves as often as is asked for; one side's middle plane is x = 0, so that it mirrors as bodies do.
struct NetGrid {
    Eigen::Vector3d centre{0, 0, 0};
    double finest = 0.002;  ///< Side of the smallest cell [m].
    int levels = 10;        ///< The cube's side is `finest` times two to the power of this.
    /// How large a cell at a place may be [m].
    std::function<double(const Eigen::Vector3d&)> cellAt;
};

/// The zero level of a distance as a closed mesh, by surface nets (Gibson 1998) on an octree: one vertex per leaf that
/// the surface crosses, then drawn onto it. The distance may be up to 12 mm more than the true one, and any less.
/// @throws std::logic_error where it differs by more, or where the surface leaves the cube.
TriangleMesh surfaceNets(const Distance& distance, const NetGrid& grid);

/// The direction in which the distance grows, by differences over `h` [m]; not of unit length.
Eigen::Vector3d gradient(const Distance& distance, const Eigen::Vector3d& p, double h);
/// The point of the surface that is straight below or above one close to it, rounded to 0.1 mm so that the last bits of
/// the mathematical library do not show.
Eigen::Vector3d onSurface(const Distance& distance, const Eigen::Vector3d& p);

}  // namespace knuckle
