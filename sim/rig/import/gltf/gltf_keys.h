#pragma once

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Replaces keys with jumps (STEP) or curves (CUBICSPLINE) between them by linear ones, since assimp takes all keys for
/// linear. @throws InputError for keys that reach past the end of their buffer.
void supplyLinearKeys(GltfSource& source);

}  // namespace knuckle
