#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// What a name of a scene stands for.
struct Named {
    std::vector<uint32_t> bodies;        ///< Of an object, its first one first; or one.
    uint32_t first = NO_INDEX, end = 0;  ///< Particles of what has no bodies.
    bool isLoose() const { return bodies.empty(); }
};

/// An object or a group of particles without bodies; none if there is none of that name.
std::optional<Named> looseNamed(const World& world, const std::string& name);
/// "object", or "object/body" where that has several. @throws InputError that names what there is.
Named named(const World& world, const std::string& name);
/// The same for bodies alone. @throws InputError for what has none, too.
std::vector<uint32_t> bodiesNamed(const World& world, const std::string& name);
/// @throws InputError that names the joints that something drives.
uint32_t drivenJointNamed(const World& world, const std::string& name);
/// A body with all that hangs on it in its object.
std::vector<uint32_t> withHanging(const World& world, const std::vector<uint32_t>& bodies);

}  // namespace knuckle
