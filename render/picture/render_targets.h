#pragma once

#include <cstdint>

#include "sim/gpu/texture.h"

namespace knuckle {

/// Everything that a frame is drawn into. Filters read the textures by their labels.
struct RenderTargets {
    /// @param factor samples an axis and pixel.
    RenderTargets(uint32_t width, uint32_t height, uint32_t factor);

    Texture surface, depth;  ///< Normals and colours, and depth, of what is seen.
    Texture shadow;          ///< Depth as the key light sees it.
    Texture shade;           ///< Half resolution: see shade.glsl.
    Texture lit, smoothed;   ///< As displayed, before and after the edges are smoothed.
    Texture resolved;        ///< The frame, where there are several samples a pixel.
    Framebuffer geometry, shadowMap, occlusion, lighting, edges, resolve;
};

/// Texels a side of the shadow map.
inline constexpr uint32_t SHADOW_SIZE = 1024;

}  // namespace knuckle
