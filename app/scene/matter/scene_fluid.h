#pragma once

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds an object of type `fluid` with its copies. @throws InputError.
void addFluid(const ObjectEntry& entry);

}  // namespace knuckle
