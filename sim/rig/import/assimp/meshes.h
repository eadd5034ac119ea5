#pragma once

#include <assimp/scene.h>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Adds all triangles, skinned into the rest pose of the nodes, with normalized weights. @throws InputError for
/// vertices that are not finite, indices out of range, counts over the limit, singular bind matrices.
void convertMeshes(const aiScene& scene, const NodeTable& table, Model& model);

}  // namespace knuckle
