#pragma once

#include <vector>

#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

/// What an accessor of numbers or vectors stands for.
struct GltfFloats {
    std::vector<float> values;
    size_t components = 1;
    std::string type;
};

/// @param isFraction whether integers stand for 0 ... 1, or -1 ... 1, although the file may not say so.
/// @throws InputError where it reaches past the end of its buffer.
GltfFloats readFloats(GltfSource& source, size_t accessor, bool isFraction);

/// Turns the integers that stand for vertices, weights, colours and keys (normalized ones, KHR_mesh_quantization) into
/// floats: assimp takes them for other numbers than they are. @throws InputError as readFloats().
void supplyFloats(GltfSource& source);

/// Gives skins without bind matrices those that the format says they have: identities. assimp crashes without.
/// @throws InputError for a skin with fewer matrices than joints.
void supplyBindMatrices(GltfSource& source);

}  // namespace knuckle
