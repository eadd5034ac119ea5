#pragma once

#include <string>

namespace knuckle {

/// A path for reading; if it begins with `assets/` and does not exist, that of the assets installed with the program or
/// with Python's module, or of the source that these were built from, if they have it.
std::string findAsset(const std::string& path);

}  // namespace knuckle
