#pragma once

#include <string>
#include <vector>

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Gives textures whose only picture is WebP (EXT_texture_webp) that one.
void supplyPictures(GltfSource& source);

/// Sentences on what of a glTF nobody here reads: extensions that it requires.
std::vector<std::string> unreadExtensions(const GltfSource& source);

/// The same on pictures of kinds that are not decoded, as KTX2.
std::vector<std::string> unreadPictures(const GltfSource& source);

}  // namespace knuckle
