#pragma once

#include <cstdint>

#include "render/settings.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/shader_source.h"
#include "sim/gpu/texture.h"

namespace knuckle {

/// What a picture needs more than others.
struct TargetNeeds {
    bool fluids = false;    ///< Surfaces of fluids are drawn.
    bool emission = false;  ///< Some of these send out light.
    bool glass = false;
};

/// All textures that a frame is drawn into. Filters read them by their labels.
struct RenderTargets {
    RenderTargets(const RenderSettings& settings, const TargetNeeds& needs);

    /// So that passes find the textures.
    void addTo(BufferTable& table) const;
    bool hasSurfaces() const { return fluidDepth.id() != 0; }
    bool hasGlass() const { return glassDepth.id() != 0; }
    bool hasEmission() const { return fluidEmission.id() != 0; }
    bool isTransparent() const { return cover.id() != 0; }
    bool hasLayers() const { return things.id() != 0; }
    /// What passes into the geometry buffers are compiled with. @param moves whether their vertices know where they
    /// were in the frame before.
    Defines layerDefines(bool moves = false) const;

    Texture surface, depth;          ///< Normals and colours, and depth, of the visible surfaces.
    Texture shadow;                  ///< Depth as seen by the key light.
    Texture shade;                   ///< Half resolution: see shade.glsl.
    Texture lit, smoothed;           ///< As displayed, or light (hasLens()), before and after edges are smoothed.
    Texture cover, smoothedCover;    ///< Of transparent frames: what of each pixel is covered.
    Texture resolved;                ///< The frame, if there are several samples a pixel, it is transparent or a draft.
    Texture fluidDepth;              ///< Depth of the nearest fluid.
    Texture fluidWide, fluidSmooth;  ///< View depth of its surface, smoothed along rows, and along columns too [m].
    Texture fluidTint, fluidGlow;    ///< Half resolution: fluid_tint.frag.
    Texture fluidEmission;           ///< The same, if any fluid sends out light.
    Texture fluidShadow;             ///< Depth of fluid as seen by the key light.
    Texture fluidBend, fluidFocus;   ///< How its surface gathers that light, along rows, and in all: fluid_focus.frag.
    Texture foam;                    ///< Light times coverage, coverage (foam.frag).
    Framebuffer fluidFront, fluidRows, fluidColumns, fluidInside, fluidShadowMap, fluidBends, fluidLens, foamCover, wet;
    Texture things, earlier;           ///< Of layers: what each pixel shows, and where that was (thing.glsl).
    Texture fluidThings;               ///< Of layers: colour word and particle of the nearest fluid.
    Texture layerPlaces, layerAlbedo;  ///< See layers.frag.
    Framebuffer layers;
    Texture glassDepth;  ///< Of the nearest glass, while that is drawn over the picture.
    Framebuffer geometry, shadowMap, glass, occlusion, lighting, edges, resolve;
};

/// Texels per side of the shadow map.
uint32_t shadowSize(const RenderSettings& settings);
/// The same of the shadow map of fluids: their shadows are soft.
inline constexpr uint32_t FLUID_SHADOW_SIZE = 256;

}  // namespace knuckle
