#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds `drains`, then `emitters`, whose nozzles must be free: to be called after everything else.
/// @throws InputError.
void addEmitters(SceneContext& context, const Json& root);

}  // namespace knuckle
