#pragma once

#include <assimp/scene.h>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Makes a bone of each separate part of the mesh: vertices of one node that triangles or shared places connect. It is
/// named after the node, the mesh or the material. @throws InputError for a model with a skeleton.
void splitIntoParts(const aiScene& scene, const NodeTable& table, Model& model);

}  // namespace knuckle
