#pragma once

#include <string>
#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Adds an object of type `actor` with its copies. @throws InputError.
void addActors(const ObjectEntry& entry);

}  // namespace knuckle
