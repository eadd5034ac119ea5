#pragma once

#include <string>
#include <vector>

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Makes textures whose only picture is WebP (EXT_texture_webp) use it.
void supplyPictures(GltfSource& source);

/// Sentences on required extensions that nothing here reads.
std::vector<std::string> unreadExtensions(const GltfSource& source);

/// The same for pictures of kinds that are not decoded, such as KTX2.
std::vector<std::string> unreadPictures(const GltfSource& source);

}  // namespace knuckle
