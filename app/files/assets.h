#pragma once

#include <string>

namespace knuckle {

/// A path of something to read; where it begins with `assets/` and nothing is there, that of the assets which were
/// installed with the program, if they have it.
std::string findAsset(const std::string& path);

}  // namespace knuckle
