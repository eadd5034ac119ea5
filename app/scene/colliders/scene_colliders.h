#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds the entries of `colliders`, each of which may stand for several. @throws InputError.
void addColliders(SceneContext& context, const Json& colliders);

}  // namespace knuckle
