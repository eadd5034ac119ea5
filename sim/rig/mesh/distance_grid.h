#pragma once

#include <span>

#include "sim/rig/mesh/triangle_tree.h"
#include "sim/world/space/collider_grid.h"

namespace knuckle {

/// The signed distance grid of a mesh, for a collider: distances to its triangles, inside by the generalized winding
/// number, so that it may have holes and triangles may face either way. Two cells of room lie around the mesh.
/// @param cell [m], > 0.
/// @throws InputError for a mesh that encloses no point of the grid, or when more than MAX_GRID_VALUES are needed, with
/// the cell that would do.
ColliderGrid makeDistanceGrid(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles,
                              float cell);

}  // namespace knuckle
