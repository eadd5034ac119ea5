#include "sim/world/builder/collider_builder.h"

#include <utility>

namespace knuckle {

void ColliderBuilder::addCollider(const Collider& collider)
{
    world_.colliders.push_back(collider);
}

uint32_t ColliderBuilder::addColliderGrid(ColliderGrid grid)
{
    world_.colliderGrids.push_back(std::move(grid));
    return static_cast<uint32_t>(world_.colliderGrids.size() - 1);
}

void ColliderBuilder::moveColliders(uint32_t count, const Pose& pose, const ClipPlay& play)
{
    ColliderMotion motion{static_cast<uint32_t>(world_.colliders.size()) - count, {}, pose, play};
    const Quaternionf back = pose.rotation.conjugate();
    for (uint32_t c = motion.firstCollider; c < world_.colliders.size(); ++c)
        motion.places.push_back({back * (world_.colliders[c].position - pose.translation),
                                 (back * world_.colliders[c].orientation).normalized()});
    world_.colliderMotions.push_back(std::move(motion));
    world_.colliders = collidersAt(world_, 0.0);
}

}  // namespace knuckle
