#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/rig/mesh/solid.h"

namespace knuckle {

struct VoxelOptions {
    float diameter = 0.0f;  ///< Particle diameter and lattice spacing [m]; 0: 3 % of the longest side.
    uint32_t particleLimit = 200000;
    bool facets = false;                         ///< Whether a convex polyhedron gets flat facets (fillPolyhedron()).
    std::optional<Eigen::Vector3f> centre = {};  ///< A point of the lattice [m]; else the centre of the mesh's bounds.
};

/// A mesh filled with particles.
struct Voxels {
    float diameter = 0.0f;                   ///< [m]
    std::vector<Eigen::Vector3f> positions;  ///< [m]
    std::vector<SurfacePoint> nearest;       ///< Per particle, the nearest point of the surface.
    std::vector<float> signedDistances;      ///< Per particle [m], negative inside.
    /// Per particle, the unit gradient of its distance; zero midway between two sides, and in a part so thin that half
    /// a diameter inwards is no deeper.
    std::vector<Eigen::Vector3f> outward;

    /// Appends a particle, with its place relative to the solid.
    void add(const Solid& solid, const Eigen::Vector3f& position);
    /// Some of them, in this order.
    Voxels chosen(std::span<const uint32_t> particles) const;
};

/// Solid voxelization on a simple cubic lattice, x fastest, then y, then z, by generalized winding number (Jacobson et
/// al. 2013), so that meshes may be open and triangles may face either way. Parts thinner than the lattice get one
/// layer, parts thin in two directions a row.
///
/// @throws InputError for a mesh that needs more particles than the limit, std::logic_error for options out of range.
Voxels voxelize(const Solid& solid, const VoxelOptions& options);

}  // namespace knuckle
