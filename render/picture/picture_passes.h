#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "render/picture/sided_pass.h"
#include "render/settings.h"
#include "shared/frame_types.h"

namespace knuckle {

/// Makes the frame from the geometry buffers and the shadow map.
class PicturePasses {
public:
    /// @param table must have "frame", "view", the targets' textures, and the buffers of FluidPass and PictureLooks.
    /// @param looks what the lighting is compiled with. @param isMirror  Whether the ground mirrors.
    PicturePasses(const Gpu& gpu, BufferTable& table, RenderTargets& targets, const RenderSettings& settings,
                  const Defines& looks, bool isMirror);
    PicturePasses(const PicturePasses&) = delete;
    PicturePasses& operator=(const PicturePasses&) = delete;

    /// Draws the ambient and key light that arrives, at half resolution.
    void drawOcclusion(KernelTimer& timer) const;
    /// Draws the final colours.
    void drawLighting(KernelTimer& timer) const { lighting_.drawScreen(timer); }
    /// What the ground mirrors, if it does, over the lit picture.
    void drawMirror(KernelTimer& timer, FluidSide side) const;
    /// The same, except ground and sky, half transparent over the existing colours.
    void drawVeil(KernelTimer& timer) const { veil_.drawScreen(timer); }
    /// Smooths edges, unless several draws do. Then averages the samples of each pixel, or enlarges a draft.
    void drawSmooth(KernelTimer& timer) const;
    /// The finished frame.
    const Framebuffer& result() const { return isResolved_ ? targets_.resolve : targets_.edges; }

private:
    void loadSmoothing(const Gpu& gpu, const BufferTable& table, const RenderSettings& settings, Defines defines);

    RenderTargets& targets_;
    bool isResolved_, isMirror_, smooths_;
    DrawPass occlusion_, lighting_, veil_, edgeFilter_, resolve_;
    SidedPass mirror_;
};

}  // namespace knuckle
