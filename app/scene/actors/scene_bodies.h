#pragma once

#include <string>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Index of an actor's body. @param where its name is in the entry. @throws InputError if there is none.
uint32_t bodyNamed(const ObjectEntry& entry, const Actor& actor, const std::string& name, const std::string& where);
/// Names of an actor's bodies in their order.
std::vector<std::string> bodyNames(const Actor& actor);

}  // namespace knuckle
