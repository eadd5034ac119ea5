#pragma once

#include <cstdint>

#include "sim/gpu/buffer_table.h"
#include "sim/gpu/texture.h"

namespace knuckle {

/// All textures that a frame is drawn into. Filters read them by their labels.
struct RenderTargets {
    /// @param factor samples per axis and pixel. @param hasSurfaces  Whether surfaces of fluids are drawn.
    /// @param isTransparent  Whether the frame says what of a pixel anything covers.
    /// @param bits of a channel of what is displayed, 8 or 16.
    RenderTargets(uint32_t width, uint32_t height, uint32_t factor, bool hasSurfaces, bool isTransparent,
                  uint32_t bits = 8);

    /// So that passes find the textures.
    void addTo(BufferTable& table) const;
    bool hasSurfaces() const { return fluidDepth.id() != 0; }
    bool isTransparent() const { return cover.id() != 0; }

    Texture surface, depth;          ///< Normals and colours, and depth, of the visible surfaces.
    Texture shadow;                  ///< Depth as seen by the key light.
    Texture shade;                   ///< Half resolution: see shade.glsl.
    Texture lit, smoothed;           ///< As displayed, before and after edges are smoothed.
    Texture cover, smoothedCover;    ///< Of transparent frames: what of each pixel is covered.
    Texture resolved;                ///< The frame, if there are several samples a pixel or it is transparent.
    Texture fluidDepth;              ///< Depth of the nearest fluid.
    Texture fluidWide, fluidSmooth;  ///< View depth of its surface, smoothed along rows, and along columns too [m].
    Texture fluidTint, fluidGlow;    ///< Half resolution: fluid_tint.frag.
    Texture fluidShadow;             ///< Depth of fluid as seen by the key light.
    Texture foam;                    ///< Light times coverage, coverage (foam.frag).
    Framebuffer fluidFront, fluidRows, fluidColumns, fluidInside, fluidShadowMap, foamCover, wet;
    Framebuffer geometry, shadowMap, occlusion, lighting, edges, resolve;
};

/// Texels per side of the shadow map.
inline constexpr uint32_t SHADOW_SIZE = 1024;
/// The same of the shadow map of fluids: their shadows are soft.
inline constexpr uint32_t FLUID_SHADOW_SIZE = 256;

}  // namespace knuckle
