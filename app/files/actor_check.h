#pragma once

#include <string>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/world/world.h"

namespace knuckle {

/// Checks that the parts of an actor fit together: each index was found to be in range before.
/// @param path of its file. @throws InputError for the first fault, with its place in the file.
void requireConsistent(const std::string& path, const Actor& actor);

/// The actor alone, of the default material. @param path of its file or model. @throws InputError for one that no scene
/// can have.
World worldOf(const std::string& path, const Actor& actor);

constexpr uint32_t FEWEST_PARTICLES = 12, MOST_PARTICLES = 200000;  ///< Of an actor.
constexpr double SMALLEST_DIAMETER = 0.001;                         ///< Of a scene [m].

/// Checks that a scene can use what was made of a model. @param file the model's. @throws InputError, std::logic_error.
void requireUsable(const std::string& file, const Actor& actor);

/// What its joints do otherwise than they say, and bodies that scenes cannot tell apart, a line each with its place in
/// the file. @param world that worldOf() made of the actor.
std::vector<std::string> actorWarnings(const Actor& actor, const World& world);

}  // namespace knuckle
