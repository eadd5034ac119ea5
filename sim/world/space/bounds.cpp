#include "sim/world/space/bounds.h"

namespace knuckle {

using Eigen::AlignedBox3f;

AlignedBox3f particleBounds(const World& world)
{
    AlignedBox3f box;
    for (const Particle& particle : world.particles) box.extend(particle.position);
    if (box.isEmpty()) return box;
    const Vector3f radius = Vector3f::Constant(world.particleRadius);
    return {box.min() - radius, box.max() + radius};
}

AlignedBox3f colliderBounds(const World& world, const Collider& collider)
{
    if (collider.grid != NO_INDEX) {
        const ColliderGrid& grid = world.colliderGrids[collider.grid];
        AlignedBox3f box{grid.drawnLow, grid.drawnHigh};
        return box.transformed(Eigen::Isometry3f(Eigen::Translation3f(collider.position) * collider.orientation));
    }
    Vector3f half = collider.halfExtents;
    if (collider.shape == ColliderShape::Sphere) half = Vector3f::Constant(collider.radius);
    if (collider.shape == ColliderShape::Capsule)
        half = {collider.radius, collider.radius + collider.halfHeight, collider.radius};
    const Eigen::Matrix3f axes = collider.orientation.normalized().toRotationMatrix().cwiseAbs();
    const Vector3f reach = axes * half;
    return {collider.position - reach, collider.position + reach};
}

}  // namespace knuckle
