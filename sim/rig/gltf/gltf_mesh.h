#pragma once

#include "sim/rig/gltf/glb.h"
#include "sim/rig/gltf/gltf_file.h"

namespace knuckle {

/// Appends a model's mesh with its materials, and its skin if it has one. @param firstBone node of the model's first
/// bone. @returns the mesh's node.
size_t addMesh(GltfFile& file, const Model& model, size_t firstBone, const GlbOptions& options);

}  // namespace knuckle
