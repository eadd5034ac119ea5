#pragma once

#include <string>

#include "sim/base/files/output_file.h"
#include "sim/rig/actor.h"

namespace knuckle {

/// The actor as JSON text, schema assets/schema/actor.schema.json. Every float survives the round trip exactly.
std::string actorText(const Actor& actor);
/// Writes it to a file that was opened as `path`: as URDF or MJCF by its ending (robot.h), else actorText(), with
/// Actor::model relative to that. @throws RunError.
void writeActor(OutputFile& file, const std::string& path, const Actor& actor);
/// The same for a file by its name. @throws RunError, InputError.
void writeActor(const std::string& path, const Actor& actor);
/// Whether a file says that it is an actor. A pipe, which can only be read once, counts as none. @throws InputError for
/// one that is no JSON.
bool isActorFile(const std::string& path);
/// @throws InputError for a file that is not an actor, of another version, or inconsistent.
Actor readActor(const std::string& path);

}  // namespace knuckle
