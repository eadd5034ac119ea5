#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds `wind` and `fields`. @throws InputError.
void addForces(SceneContext& context, const Json& root);

}  // namespace knuckle
