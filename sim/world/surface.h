#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace knuckle {

/// Of a particle that is in no lattice, see SurfaceDistance::ends.
inline constexpr uint32_t ALL_ENDS = 63;

/// Where a particle of a body stands to the surface of the body (Macklin et al. 2014, 5.1).
struct SurfaceDistance {
    float distance = 0.0f;                    ///< Of the particle's centre [m], negative inside.
    /// The distance's unit gradient, out of the body, in the rest pose; zero where it has none: midway between two
    /// sides, in particles that bodies share, and in loose ones.
    Eigen::Vector3f outward{0, 0, 0};
    /// Where a box lattice ends at the particle: bits 2 k and 2 k + 1, towards - and + along axis k of the rest pose.
    uint32_t ends = ALL_ENDS;
};

/// Of a point of a box about the origin with edges of twice halfExtents [m]. Where faces are equally near, to within a
/// hundredth of the least extent, outward lies between their normals.
SurfaceDistance boxSurface(const Eigen::Vector3f& point, const Eigen::Vector3f& halfExtents);
/// Of a point of a capsule along y about the origin; halfHeight 0 for a sphere [m].
SurfaceDistance capsuleSurface(const Eigen::Vector3f& point, float radius, float halfHeight);
/// Of the particles of a box lattice, wherever it stands and however long its edges are; empty where they are none.
std::vector<SurfaceDistance> latticeSurface(std::span<const Eigen::Vector3f> positions, float diameter);

}  // namespace knuckle
