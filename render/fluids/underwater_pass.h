#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "render/settings.h"
#include "shared/draw_types.h"
#include "sim/gpu/buffer.h"

namespace knuckle {

/// Draws what a camera in fluid sees. Whether it is in one, only the device knows: kernels decide whether there is
/// anything to draw.
class UnderwaterPass {
public:
    /// Adds "submersion" and its own buffers and textures to the table, which must have "frame", "view", "positions",
    /// the targets' textures and the buffers of FluidLooks and SphereLists. @param fluidCount  Particles.
    UnderwaterPass(const Gpu& gpu, BufferTable& table, uint32_t fluidCount, const RenderSettings& settings,
                   const RenderTargets& targets);
    UnderwaterPass(const UnderwaterPass&) = delete;
    UnderwaterPass& operator=(const UnderwaterPass&) = delete;

    /// Decides, before fluids are drawn from outside, and maps their surface from above.
    void update(KernelTimer& timer);
    /// Of the lit picture, into that with fluids.
    void draw(KernelTimer& timer) const;

private:
    uint32_t fluidCount_;
    Buffer<uint32_t> submersion_;
    Buffer<gpu::DrawArguments> draws_;
    Texture topDepth_, topRows_, top_;  ///< The map from above, and its heights and slopes.
    Framebuffer topMap_, rowsOfTop_, columnsOfTop_;
    Kernel count_, write_;
    DrawPass points_, rows_, columns_, shade_;
};

}  // namespace knuckle
