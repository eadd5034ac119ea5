#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"

namespace knuckle {

/// Fluids are drawn over the lit picture. What else is drawn over it comes before them where it is behind their
/// surface, so that it is seen through them, and else after them.
enum class FluidSide { Behind, InFront };

/// A pass over the lit picture, of things on one side of fluids at a time (common/rays/fluid_side.glsl).
class SidedPass {
public:
    SidedPass() = default;
    /// As DrawPass. @param reads without the fluids' depth.
    SidedPass(const Gpu& gpu, const BufferTable& table, DrawShaders shaders, std::vector<std::string> reads,
              const Framebuffer& target, const RenderTargets& targets, GLenum culled = GL_NONE);

    /// Without surfaces of fluids, everything is in front.
    const DrawPass& of(FluidSide side) const { return side == FluidSide::Behind ? behind_ : inFront_; }

private:
    DrawPass behind_, inFront_;
};

}  // namespace knuckle
