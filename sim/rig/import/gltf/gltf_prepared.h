#pragma once

#include <map>
#include <string>
#include <vector>

namespace knuckle {

/// A glTF file as assimp gets it.
struct PreparedGltf {
    std::string bytes;                             ///< The whole file; empty: it is no glTF, or fine as it is.
    std::string added;                             ///< What GltfSource::ADDED_FILE holds, which `bytes` may name.
    std::map<std::string, std::string> originals;  ///< By the new name of a joint: what it was called.
    std::vector<std::string> notes, missing;       ///< What of the model, and of its pictures, nobody reads.
};

/// Changes in memory what assimp would not understand. @throws InputError for what is damaged.
PreparedGltf prepareGltf(const std::string& path);

}  // namespace knuckle
