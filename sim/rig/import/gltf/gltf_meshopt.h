#pragma once

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Decompresses buffer views that are compressed with meshopt (EXT_meshopt_compression). A view that cannot be
/// decompressed keeps its plain bytes, if it has any. @throws InputError if it has none.
void decodeMeshopt(GltfSource& source);

}  // namespace knuckle
