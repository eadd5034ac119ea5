#pragma once

#include <map>
#include <string>
#include <vector>

namespace knuckle {

/// A glTF file as passed to assimp.
struct PreparedGltf {
    std::string bytes;                             ///< The whole file; empty if it is not glTF, or needs no change.
    std::string added;                             ///< Contents of GltfSource::ADDED_FILE, which `bytes` may name.
    std::map<std::string, std::string> originals;  ///< By the new name of a joint: its old name.
    std::vector<std::string> notes, missing;       ///< Parts of the model, and of its pictures, that nothing reads.
};

/// Changes in memory what assimp would misread. @throws InputError for damaged data.
PreparedGltf prepareGltf(const std::string& path);

}  // namespace knuckle
