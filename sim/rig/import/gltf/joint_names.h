#pragma once

#include <map>
#include <string>

#include "sim/base/json.h"

namespace knuckle {

/// Gives every joint of a skin, and every node that a clip moves, a name of its own: glTF tells nodes apart by their
/// numbers, assimp by their names, so of two figures with bones of the same names it mixes up clips. The second "hips"
/// becomes "hips#2". @param gltf its JSON. @returns by the new names what they were before.
std::map<std::string, std::string> nameJoints(nlohmann::json& gltf);

}  // namespace knuckle
