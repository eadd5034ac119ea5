#pragma once

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Obstacles.
class ColliderBuilder : public virtual WorldDraft {
public:
    void addCollider(const Collider& collider);
    /// From the start the last `count` colliders move together as a clip says, beginning where that has them at 0.
    /// @param pose of the frame that moves, where they stand.
    void moveColliders(uint32_t count, const Pose& pose, const ClipPlay& play);
    /// @returns its index, for Collider::grid.
    uint32_t addColliderGrid(ColliderGrid grid);
};

}  // namespace knuckle
