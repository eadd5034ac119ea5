#pragma once

#include <string>

#include "sim/world/world.h"

namespace knuckle {

/// `actorCount` figures of a model in a box of 4 x 4 m with walls, in layers of 5 x 5 that are 2 m apart. They play a
/// clip on the spot, each from another moment, until they are let go at a time [s].
/// @throws InputError for a model that cannot be read or has no such clip.
World troupeWorld(uint32_t actorCount, float releaseTime, const std::string& model, const Settings& settings = {});

/// `actorCount` figures of a model in their skins, with the default number of particles, in rows of 5 on the ground.
/// They play the same clip.
/// @throws InputError as troupeWorld(), and for a model without a mesh.
World crowdWorld(uint32_t actorCount, const std::string& model);

}  // namespace knuckle
