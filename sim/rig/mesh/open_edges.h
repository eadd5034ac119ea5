#pragma once

#include <span>

#include "sim/rig/mesh/triangle_tree.h"

namespace knuckle {

/// How wide the widest opening of a mesh is: the diagonal of the box around edges that belong to one triangle only and
/// hang together [the mesh's unit]. Vertices at one place count as one; triangles without an area do not count.
/// 0: it is closed.
float widestOpening(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles);

/// The two sides of a sheet, half of `thickness` away from its triangles along the mean normals of its vertices, and
/// its rim along open edges.
TriangleMesh thickened(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles, float thickness);

}  // namespace knuckle
