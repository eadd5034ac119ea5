#pragma once

#include <map>
#include <utility>
#include <vector>

#include "shared/gpu_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// The materials and pictures of all skins, in the format of shaders/render/skins/skin_looks.glsl.
struct SkinLooks {
    std::vector<gpu::vec4> materials;
    std::vector<gpu::uvec4> levels;
    std::vector<uint32_t> texels;

    /// Adds the materials and pictures of a mesh. @returns the index of its first material.
    uint32_t add(const SkinMesh& mesh);

private:
    /// Of a picture's mipmap, the first of `levels` and how many.
    using Range = std::pair<float, float>;
    /// Adds the picture, if there is one, and its mipmap. @param isColor  Whether its numbers are colours.
    Range addPicture(const SkinMesh& mesh, uint32_t index, bool isColor);

    std::map<std::pair<uint32_t, bool>, Range> added_;  ///< Of the mesh.
};

}  // namespace knuckle
