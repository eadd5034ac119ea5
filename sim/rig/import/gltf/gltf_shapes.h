#pragma once

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Moves vertices as the shapes (morph targets) say that a file has in use from the start, and drops all shapes.
/// @throws InputError for shapes that reach past the end of their buffer or are of other sizes than their mesh.
void applyShapes(GltfSource& source);

}  // namespace knuckle
