#pragma once

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Replaces buffer views that are compressed with meshopt (EXT_meshopt_compression) by what they stand for. One that
/// cannot be decompressed and has plain bytes as well keeps these. @throws InputError where it has none.
void decodeMeshopt(GltfSource& source);

}  // namespace knuckle
