#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// The files beside a model that it names: buffers and pictures of glTF, materials and pictures of OBJ. What cannot be
/// read has none; the import says why.
std::vector<std::string> filesOfModel(const std::string& path);

}  // namespace knuckle
