#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds `drains`, then `emitters`, whose nozzles must not be in anything that is there: after everything else.
/// @throws InputError.
void addEmitters(SceneContext& context, const Json& root);

}  // namespace knuckle
