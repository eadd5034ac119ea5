#pragma once

#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Lets go of the copies of an actor as `release` says. @param objects of the world, a copy each. @throws InputError.
void releaseActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects);

/// Notes the particles of an object. @param first of them.
void noteParticles(const ObjectEntry& entry, uint32_t first);
/// Adds the releases by touch, after all objects. @throws InputError for a name that no object has.
void addTouches(SceneContext& context);

}  // namespace knuckle
