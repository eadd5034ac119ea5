#include "render/picture/sided_pass.h"

namespace knuckle {

SidedPass::SidedPass(const Gpu& gpu, const BufferTable& table, DrawShaders shaders, std::vector<std::string> reads,
                     const Framebuffer& target, const RenderTargets& targets, GLenum culled)
{
    if (!targets.hasSurfaces()) {
        inFront_ = DrawPass(gpu, table, shaders, reads, target, culled);
        return;
    }
    reads.push_back("fluidWidePicture");
    const auto with = [&](const char* side) {
        DrawShaders sided = shaders;
        sided.defines.push_back({side, "1"});
        return DrawPass(gpu, table, sided, reads, target, culled);
    };
    behind_ = with("BEHIND_FLUIDS");
    inFront_ = with("BEFORE_FLUIDS");
}

}  // namespace knuckle
