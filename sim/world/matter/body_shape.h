#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace knuckle {

/// What is drawn of a rigid body instead of its particles: all points within `radius` of a box along the axes of its
/// rest pose. A ball's box is a point, a capsule's a line; the box of a lattice of particles goes through the outermost
/// ones, so that its edges are as round as they are.
struct BodyShape {
    uint32_t body = 0;                   ///< Index into World::bodies.
    Eigen::Vector3f middle{0, 0, 0};     ///< In the rest pose of its object [m].
    Eigen::Vector3f halfSides{0, 0, 0};  ///< Of the box [m], >= 0.
    float radius = 0.0f;                 ///< [m], > 0.

    /// Whether a point of the rest pose is inside, or within a thousandth of the radius of it.
    bool contains(const Eigen::Vector3f& place) const;
};

/// The shape around a lattice of particles. @param positions not empty [m].
BodyShape shapeAround(std::span<const Eigen::Vector3f> positions, float particleRadius);

struct World;

/// Validates the shapes of bodies. @throws std::logic_error.
void validateBodyShapes(const World& world);

}  // namespace knuckle
