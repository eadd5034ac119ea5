#pragma once

#include "render/draw_pass.h"
#include "render/layers/layers.h"
#include "render/picture/render_targets.h"
#include "shared/frame_types.h"

namespace knuckle {

/// @param view of the last frame. @param tanHalfFov vertical. @param height of the picture [pixels]
LayerCamera layerCamera(const gpu::FrameView& view, float tanHalfFov, uint32_t height);

/// Turns geometry buffers into layers, and reads them.
class LayerPasses {
public:
    /// @param table must have "frame", "view" and the targets' textures. @param targets with layers; must outlive it.
    LayerPasses(const Gpu& gpu, const BufferTable& table, const RenderTargets& targets);
    LayerPasses(const LayerPasses&) = delete;
    LayerPasses& operator=(const LayerPasses&) = delete;

    void draw(KernelTimer& timer) const { pass_.drawScreen(timer); }
    /// Waits for what was drawn last. @param view of it. @param tanHalfFov vertical.
    Layers read(const gpu::FrameView& view, float tanHalfFov) const;

private:
    const RenderTargets& targets_;
    DrawPass pass_;
};

}  // namespace knuckle
