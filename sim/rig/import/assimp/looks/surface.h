#pragma once

#include <assimp/scene.h>

#include <string>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Fills Model::surface for the vertices that convertMeshes() added. Textures that cannot be read are noted.
/// @param path of the model's file.
void convertSurface(const aiScene& scene, const NodeTable& table, const std::string& path, Model& model);

}  // namespace knuckle
