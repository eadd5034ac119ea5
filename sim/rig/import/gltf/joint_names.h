#pragma once

#include <map>
#include <string>

#include "sim/base/json.h"

namespace knuckle {

/// Gives every joint of a skin, and every node that a clip moves, a unique name: glTF identifies nodes by number,
/// assimp by name, so it mixes up clips of two figures with bones of the same names. The second "hips" becomes
/// "hips#2". @param gltf its JSON. @returns the old names by the new ones.
std::map<std::string, std::string> nameJoints(nlohmann::json& gltf);

}  // namespace knuckle
