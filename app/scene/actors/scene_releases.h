#pragma once

#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Lets the copies of an actor go as `release` says. @param objects of the world, a copy each. @throws InputError.
void releaseActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

/// Notes which particles an object has got. @param first of them.
void noteParticles(const ObjectEntry& entry, uint32_t first);
/// Adds the releases by touch, once all objects are there. @throws InputError for a name that none has.
void addTouches(SceneContext& context);

}  // namespace knuckle
