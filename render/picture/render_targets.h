#pragma once

#include <cstdint>

#include "sim/gpu/texture.h"

namespace knuckle {

/// All textures that a frame is drawn into. Filters read them by their labels.
struct RenderTargets {
    /// @param factor samples per axis and pixel.
    RenderTargets(uint32_t width, uint32_t height, uint32_t factor);

    Texture surface, depth;  ///< Normals and colours, and depth, of the visible surfaces.
    Texture shadow;          ///< Depth as seen by the key light.
    Texture shade;           ///< Half resolution: see shade.glsl.
    Texture lit, smoothed;   ///< As displayed, before and after edges are smoothed.
    Texture resolved;        ///< The frame, if there are several samples a pixel.
    Framebuffer geometry, shadowMap, occlusion, lighting, edges, resolve;
};

/// Texels per side of the shadow map.
inline constexpr uint32_t SHADOW_SIZE = 1024;

}  // namespace knuckle
