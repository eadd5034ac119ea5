#pragma once

#include <string>

#include "app/json/json.h"
#include "sim/rig/actor.h"

namespace knuckle {

/// The field `skin` of an actor's file: the mesh and its weights, and those of the particles.
std::string skinText(const ActorSkin& skin);

/// The inverse, of a document that the schema has completed and an actor that has all else.
/// @throws InputError for lists of different lengths, numbers of bodies or vertices that are none, weights whose sum is
/// not 1.
ActorSkin readSkin(const std::string& path, const Json& root, const Actor& actor);

}  // namespace knuckle
