#include "sim/world/collider_distance.h"

namespace knuckle {

float colliderDistance(const World& world, const Collider& c, const Vector3f& point)
{
    const Vector3f p = c.orientation.conjugate() * (point - c.position);
    if (c.shape == ColliderShape::Mesh) return meshDistance(world.colliderGrids[c.grid], p);
    if (c.shape == ColliderShape::Heightfield) return heightfieldDistance(world.colliderGrids[c.grid], p);
    return regionDistance(c, point);
}

}  // namespace knuckle
