#pragma once

#include <assimp/scene.h>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Makes a bone of each separate part of the mesh: of what triangles and corners at the same place connect in one
/// node. It has the name of the node, the mesh or the material. @throws InputError for a model with a skeleton.
void splitIntoParts(const aiScene& scene, const NodeTable& table, Model& model);

}  // namespace knuckle
