#pragma once

#include <string>

#include "app/json/json.h"
#include "sim/base/files/output_file.h"
#include "sim/rig/actor.h"

namespace knuckle {

/// The actor as JSON text, schema assets/schema/actor.schema.json. Every float survives the round trip exactly.
std::string actorText(const Actor& actor);
/// The same as an archive of NumPy's arrays (npz/actor_arrays.h).
std::string npzText(const Actor& actor);
/// Writes it to a file that was opened as `path`: as NPZ, URDF or MJCF (robot.h) by its ending, else as JSON, with
/// Actor::model relative to that. @throws RunError.
void writeActor(OutputFile& file, const std::string& path, const Actor& actor);
/// The same for a file by its name. @throws RunError, InputError.
void writeActor(const std::string& path, const Actor& actor);
/// Endings of what writeActor() writes.
const std::vector<const char*>& actorEndings();
/// Whether a name ends as that of an actor file that can be read.
bool isActorName(const std::string& path);
/// Whether a file is an actor: ends in .npz, or says so. A pipe, which can only be read once, counts as none.
/// @throws InputError for one that is no JSON.
bool isActorFile(const std::string& path);
/// @throws InputError for a file that is not an actor, of another version, or inconsistent.
Actor readActor(const std::string& path);
/// The same for a document in memory, beside whose path its model lies.
Actor actorOf(JsonFile file);

}  // namespace knuckle
