#pragma once

#include <string>

namespace knuckle {

/// A path for reading; if it begins with `assets/` and does not exist, that of the assets installed with the program,
/// if they have it.
std::string findAsset(const std::string& path);

}  // namespace knuckle
