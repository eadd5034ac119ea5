#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "shared/frame_types.h"

namespace knuckle {

/// Makes the frame of what has been drawn into the geometry buffers and the shadow map.
class PicturePasses {
public:
    /// @param table must have "frame" and "view". @param targets are added to it.
    /// @param veilOpacity of drawVeil(), 0 ... 1; there is none of 1.
    PicturePasses(const Gpu& gpu, BufferTable& table, RenderTargets& targets, float veilOpacity);
    PicturePasses(const PicturePasses&) = delete;
    PicturePasses& operator=(const PicturePasses&) = delete;

    /// Ambient and key light that arrives, at half resolution.
    void drawOcclusion(KernelTimer& timer) const;
    /// Colours, ready to be seen.
    void drawLighting(KernelTimer& timer) const { lighting_.drawScreen(timer); }
    /// The same, but for ground and sky, half transparent over the colours that are there.
    void drawVeil(KernelTimer& timer) const { veil_.drawScreen(timer); }
    /// Smooth edges, then the mean of the samples of each pixel, where there are several.
    void drawSmooth(KernelTimer& timer) const;
    /// The finished frame.
    const Framebuffer& result() const { return isResolved_ ? targets_.resolve : targets_.edges; }

private:
    RenderTargets& targets_;
    bool isResolved_;
    DrawPass occlusion_, lighting_, veil_, edgeFilter_, resolve_;
};

}  // namespace knuckle
