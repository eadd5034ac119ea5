#pragma once

#include <map>
#include <string>

namespace knuckle {

/// A glTF file in which every joint of a skin has a name of its own.
struct NamedJoints {
    std::string bytes;                             ///< The whole file; empty: it is no glTF, or has such names already.
    std::map<std::string, std::string> originals;  ///< By the new name: what it was called.
};

/// glTF tells nodes apart by their numbers, assimp by their names: of two figures with bones of the same names it mixes
/// up clips. The second "hips" becomes "hips#2".
NamedJoints nameJoints(const std::string& path);

}  // namespace knuckle
