#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "shared/frame_types.h"

namespace knuckle {

/// Makes the frame from the geometry buffers and the shadow map.
class PicturePasses {
public:
    /// @param table must have "frame", "view", the targets' textures, and the buffers of FluidPass.
    /// @param veilOpacity of drawVeil(), 0 ... 1; 1: no veil.
    PicturePasses(const Gpu& gpu, BufferTable& table, RenderTargets& targets, float veilOpacity);
    PicturePasses(const PicturePasses&) = delete;
    PicturePasses& operator=(const PicturePasses&) = delete;

    /// Draws the ambient and key light that arrives, at half resolution.
    void drawOcclusion(KernelTimer& timer) const;
    /// Draws the final colours.
    void drawLighting(KernelTimer& timer) const { lighting_.drawScreen(timer); }
    /// The same, except ground and sky, half transparent over the existing colours.
    void drawVeil(KernelTimer& timer) const { veil_.drawScreen(timer); }
    /// Smooths edges, then averages the samples of each pixel, if there are several.
    void drawSmooth(KernelTimer& timer) const;
    /// The finished frame.
    const Framebuffer& result() const { return isResolved_ ? targets_.resolve : targets_.edges; }

private:
    RenderTargets& targets_;
    bool isResolved_;
    DrawPass occlusion_, lighting_, veil_, edgeFilter_, resolve_;
};

}  // namespace knuckle
