#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// The files that a model names: buffers and pictures of glTF, materials and pictures of OBJ. Empty for models that
/// cannot be read; the import reports the reason.
std::vector<std::string> filesOfModel(const std::string& path);

}  // namespace knuckle
