#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds the grid of a collider of the type `mesh` or `heightfield`, and sets `collider` to it. @throws InputError.
void addMeshGrid(const SceneEntry& entry, Collider& collider);
void addHeightfield(const SceneEntry& entry, Collider& collider);

}  // namespace knuckle
