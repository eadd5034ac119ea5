#pragma once

#include <vector>

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// The values of an accessor of numbers or vectors.
struct GltfFloats {
    std::vector<float> values;
    size_t components = 1;
    std::string type;
};

/// @param isFraction whether integers mean 0 ... 1, or -1 ... 1, although the file may not say so.
/// @throws InputError if it reaches past the end of its buffer.
GltfFloats readFloats(GltfSource& source, size_t accessor, bool isFraction);

/// Converts the integers of vertices, weights, colours and keys (normalized ones, KHR_mesh_quantization) to floats,
/// since assimp misreads them. @throws InputError as readFloats().
void supplyFloats(GltfSource& source);

/// Gives skins without bind matrices the identities that the format prescribes. assimp crashes without.
/// @throws InputError for a skin with fewer matrices than joints.
void supplyBindMatrices(GltfSource& source);

}  // namespace knuckle
