#pragma once

#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Whether an actor has a `drive`.
bool isDriven(const Json& actor);
/// Drives the copies of an actor as `drive` says. @param objects of the world, a copy each. @throws InputError.
void driveActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

}  // namespace knuckle
