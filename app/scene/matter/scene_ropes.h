#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether an entry of `objects` is a rope or cloth.
bool isRopeObject(const Json& json);
/// Adds a rope or cloth with its copies. @throws InputError.
void addRopeObject(const ObjectEntry& entry);

}  // namespace knuckle
