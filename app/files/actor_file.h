#pragma once

#include <string>

#include "sim/actor/actor.h"

namespace knuckle {

/// The actor as JSON text, schema assets/schema/actor.schema.json. Every float survives the round trip exactly.
std::string actorText(const Actor& actor);
/// Writes actorText() under a temporary name and renames it; Actor::model becomes relative to `path`.
/// @throws RunError, InputError.
void writeActor(const std::string& path, const Actor& actor);
/// @throws InputError for a file that is not an actor, of another version, or inconsistent.
Actor readActor(const std::string& path);

}  // namespace knuckle
