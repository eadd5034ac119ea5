#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/actor/mesh/triangle_tree.h"

namespace knuckle {

struct VoxelOptions {
    float diameter = 0.0f;  ///< Particle diameter and lattice spacing [m]; 0: 3 % of the longest side.
    uint32_t particleLimit = 200000;
};

/// A mesh filled with particles on a simple cubic lattice whose centre is the centre of the mesh's bounds.
struct Voxels {
    float diameter = 0.0f;                   ///< [m]
    std::vector<Eigen::Vector3f> positions;  ///< [m], x fastest, then y, then z.
    std::vector<SurfacePoint> nearest;       ///< Per particle, the nearest point of the surface.
    std::vector<float> signedDistances;      ///< Per particle [m], negative inside.
    /// Per particle, the unit gradient of its distance; zero midway between two sides, also of a part so thin that half
    /// a diameter inwards does not lead deeper.
    std::vector<Eigen::Vector3f> outward;
};

/// Solid voxelization by generalized winding number (Jacobson et al. 2013), so that the mesh need not be closed nor
/// its triangles face one way. Parts thinner than the lattice keep one layer, those thinner in two directions a row.
///
/// @throws InputError for a mesh that is empty or needs more particles than the limit, std::logic_error for options out
/// of range.
Voxels voxelize(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles,
                const VoxelOptions& options);

}  // namespace knuckle
