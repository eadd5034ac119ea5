#pragma once

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
    /// Adds the picture and its mipmap.
    void addPicture(TexturePicture picture);
};

}  // namespace knuckle
