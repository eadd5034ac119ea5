#pragma once

#include <Eigen/Geometry>
#include <cstdint>

namespace knuckle {

enum class ColliderShape : uint32_t { Plane, Box, Sphere, Capsule, Mesh, Heightfield };

/// A part of space.
struct Region {
    ColliderShape shape = ColliderShape::Plane;
    Eigen::Vector3f position{0, 0, 0};              ///< A point of the plane, a grid's origin, else the centre [m].
    Eigen::Quaternionf orientation{1, 0, 0, 0};     ///< A plane's normal, a capsule's axis are its +Y (Eigen ctor is
                                                    ///< wxyz).
    Eigen::Vector3f halfExtents{0.5f, 0.5f, 0.5f};  ///< Box only [m].
    float radius = 0.5f;                            ///< Sphere and capsule [m].
    float halfHeight = 0.5f;                        ///< Capsule: half the distance between its two sphere centres [m].
};

/// Signed distance of a point to the surface of a plane, box, sphere or capsule [m], negative inside.
float regionDistance(const Region& region, const Eigen::Vector3f& point);

}  // namespace knuckle
