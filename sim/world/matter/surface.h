#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace knuckle {

/// SurfaceDistance::ends of a particle without a lattice.
inline constexpr uint32_t ALL_ENDS = 63;

/// A particle's distance to the surface of its body, and the exit direction (Macklin et al. 2014, 5.1).
struct SurfaceDistance {
    float distance = 0.0f;  ///< Of the particle's centre [m], negative inside.
    /// Unit vector from the particle to the nearest surface and out, in the rest pose. Zero if there is no unique one:
    /// midway between two sides, for shared particles, and for loose ones.
    Eigen::Vector3f outward{0, 0, 0};
    /// Where a box lattice ends at the particle: bits 2 k and 2 k + 1, towards - and + along axis k of the rest pose.
    uint32_t ends = ALL_ENDS;
};

/// For a point of a box about the origin with edges of twice halfExtents [m]. If faces are equally near, within a
/// hundredth of the least extent, outward lies between their normals.
SurfaceDistance boxSurface(const Eigen::Vector3f& point, const Eigen::Vector3f& halfExtents);
/// For a point of a capsule along y about the origin; halfHeight 0 for a sphere [m].
SurfaceDistance capsuleSurface(const Eigen::Vector3f& point, float radius, float halfHeight);
/// For the particles of a box lattice at any place, with edges of any length; empty if they form none.
std::vector<SurfaceDistance> latticeSurface(std::span<const Eigen::Vector3f> positions, float diameter);

}  // namespace knuckle
