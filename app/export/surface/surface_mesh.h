#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "app/export/surface/fluid_field.h"

namespace knuckle {

/// A closed mesh: each edge is of two triangles, once in each direction.
struct SurfaceMesh {
    std::vector<Eigen::Vector3f> places;             ///< [m]
    std::vector<Eigen::Vector3f> normals;            ///< Outwards, unit.
    std::vector<std::array<uint32_t, 3>> triangles;  ///< Counter-clockwise seen from outside.
};

/// The surface at which a field is a half. Each cell of the grid is cut into six tetrahedra around a diagonal (Kuhn
/// 1960), alike in all cells, so that they fit.
SurfaceMesh surfaceOf(const FluidField& field);

}  // namespace knuckle
