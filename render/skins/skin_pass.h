#pragma once

#include "render/draw_pass.h"
#include "render/layers/earlier_buffers.h"
#include "render/picture/render_targets.h"
#include "render/skins/skin_buffers.h"
#include "sim/gpu/kernel.h"

namespace knuckle {

/// Draws the skins of objects, deformed on the device by their bodies' motion, with detail by their size on screen.
class SkinPass {
public:
    /// @param table must have "frame", "view", "bodyCentres" and "bodyRotations".
    /// @throws InputError for skins that are too large for the device.
    SkinPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderTargets& targets);
    SkinPass(const SkinPass&) = delete;
    SkinPass& operator=(const SkinPass&) = delete;

    bool empty() const { return buffers_.wearerCount == 0; }
    /// Poses the vertices that a frame's draw calls need.
    void update(KernelTimer& timer);
    /// Into the shadow map.
    void drawShadow(KernelTimer& timer) const;
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const;
    /// Remembers where vertices are, for the layers of the next frame.
    void endFrame() { earlier_.take(); }

private:
    /// @param first of the draws of wearers. @param culled faces of one-sided skins.
    void draw(KernelTimer& timer, const DrawPass& pass, uint32_t first, GLenum culled) const;

    SkinBuffers buffers_;
    EarlierBuffers earlier_;
    Kernel lod_, pose_;
    DrawPass skins_, shadow_;
};

}  // namespace knuckle
