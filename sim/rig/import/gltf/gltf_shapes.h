#pragma once

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// Moves vertices by the shapes (morph targets) that a file uses from the start, and drops all shapes. @throws
/// InputError for shapes that reach past the end of their buffer or have other sizes than their mesh.
void applyShapes(GltfSource& source);

}  // namespace knuckle
