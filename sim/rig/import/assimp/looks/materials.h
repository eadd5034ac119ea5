#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// The result of converting a material of the scene.
struct ConvertedMaterial {
    uint32_t index = NO_INDEX;                            ///< In ModelSurface::materials; NO_INDEX if no mesh has it.
    unsigned uvChannel = 0;                               ///< Of its picture's places.
    Eigen::Affine2f moved = Eigen::Affine2f::Identity();  ///< From the mesh's places to the picture's, v downwards.
};

/// Fills the materials of those of the scene's meshes that are part of the model, and reads their textures. @returns
/// per material of the scene.
std::vector<ConvertedMaterial> convertMaterials(const aiScene& scene, const NodeTable& table, const std::string& path,
                                                Model& model);

}  // namespace knuckle
