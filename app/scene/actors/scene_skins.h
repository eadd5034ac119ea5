#pragma once

#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Makes the copies of an actor or of a rigid mesh wear the mesh that they were made from. @param objects of the world,
/// a copy each. @throws InputError if there is none.
void wearSkin(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

}  // namespace knuckle
