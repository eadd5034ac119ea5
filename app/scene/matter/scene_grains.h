#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds an object of type `grains` with its copies. @throws InputError.
void addGrains(const ObjectEntry& entry);

}  // namespace knuckle
