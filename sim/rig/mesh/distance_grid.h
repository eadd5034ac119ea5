#pragma once

#include <span>

#include "sim/rig/mesh/triangle_tree.h"
#include "sim/world/space/collider_grid.h"

namespace knuckle {

/// The signed distance grid of a mesh, for a collider: distances to its triangles, with the sign by generalized winding
/// number, so that it may have holes and triangles may face either way. It extends two cells beyond the mesh.
/// @param cell [m], > 0.
/// @throws InputError for a mesh that encloses no point of the grid, or if more than MAX_GRID_VALUES are needed, with a
/// cell that works.
ColliderGrid makeDistanceGrid(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles,
                              float cell);

/// The same of a sheet, whether it is closed or not: half of `thickness` [m], > 0, to each side of its triangles is
/// solid, and nothing else. What is drawn of it is that thick, too. A particle must keep two cells away from its
/// middle.
ColliderGrid makeSheetGrid(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles, float cell,
                           float thickness);

}  // namespace knuckle
