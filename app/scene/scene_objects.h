#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds all entries of `objects` with their copies: ropes and cloth last, since they may be attached to others.
/// @throws InputError.
void addObjects(SceneContext& context, const Json& objects);

}  // namespace knuckle
