#pragma once

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Obstacles.
class ColliderBuilder : public virtual WorldDraft {
public:
    void addCollider(const Collider& collider);
    /// From the start, a clip moves the last `count` colliders together, beginning at its place at time 0.
    /// @param pose of the moving frame at the place of the colliders.
    void moveColliders(uint32_t count, const Pose& pose, const ClipPlay& play);
    /// @returns its index, for Collider::grid.
    uint32_t addColliderGrid(ColliderGrid grid);
};

}  // namespace knuckle
