#pragma once

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Replaces keys between which values jump (STEP) or follow a curve (CUBICSPLINE) by ones between which they run
/// straight: assimp takes all keys for such. @throws InputError for keys that reach past the end of their buffer.
void supplyLinearKeys(GltfSource& source);

}  // namespace knuckle
