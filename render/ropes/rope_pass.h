#pragma once

#include "render/draw_pass.h"
#include "render/layers/earlier_buffers.h"
#include "render/picture/render_targets.h"
#include "render/settings.h"
#include "shared/draw_types.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/kernel.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws ropes as tubes of twisted strands through their particles (World::drawn), on the device.
class RopePass {
public:
    /// @param table must have "frame", "view", "positions", "velocities" and "distanceStates".
    RopePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
             const RenderTargets& targets);
    RopePass(const RopePass&) = delete;
    RopePass& operator=(const RopePass&) = delete;

    /// Finds where the ropes of a frame go.
    void update(KernelTimer& timer);
    /// Into the shadow map.
    void drawShadow(KernelTimer& timer) const;
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const;
    /// Remembers where ropes are, for the layers of the next frame.
    void endFrame() { earlier_.take(); }

private:
    /// @returns whether any of them may tear.
    bool upload(BufferTable& table, const World& world, const RenderSettings& settings);

    Buffer<gpu::vec4> ropes_, looks_, frames_;
    Buffer<gpu::uvec2> nodes_;
    Buffer<uint32_t> indices_;
    Buffer<gpu::DrawElementsArguments> draws_;
    EarlierBuffers earlier_;
    Kernel place_;
    DrawPass tubes_, shadow_;
};

}  // namespace knuckle
