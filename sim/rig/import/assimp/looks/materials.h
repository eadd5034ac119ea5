#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// What became of a material of the scene.
struct ConvertedMaterial {
    uint32_t index = NO_INDEX;  ///< In ModelSurface::materials; NO_INDEX where no mesh has it.
    unsigned uvChannel = 0;     ///< Of the places in its picture.
    Eigen::Affine2f moved = Eigen::Affine2f::Identity();  ///< Where it has them, v downwards.
};

/// Fills the materials that the scene's meshes have which are taken, and reads their textures. @returns per material of
/// the scene.
std::vector<ConvertedMaterial> convertMaterials(const aiScene& scene, const NodeTable& table, const std::string& path,
                                                Model& model);

}  // namespace knuckle
