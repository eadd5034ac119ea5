#pragma once

#include <vector>

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "render/settings.h"

namespace knuckle {

/// The light of a frame's draws, and the picture that is developed from it; nothing without hasLens().
class LensPasses {
public:
    /// @param table must have "frame" and the targets' textures.
    LensPasses(const Gpu& gpu, BufferTable& table, const RenderTargets& targets, const RenderSettings& settings);
    LensPasses(const LensPasses&) = delete;
    LensPasses& operator=(const LensPasses&) = delete;

    bool empty() const { return exposed_.id() == 0; }
    /// Begins a frame.
    void begin() const { exposure_.clear(); }
    /// Adds a draw.
    void expose(KernelTimer& timer) const { expose_.drawScreen(timer); }
    void develop(KernelTimer& timer) const;
    /// The finished frame.
    const Framebuffer& result() const { return development_; }

private:
    /// Half of the size of the one before, softer and softer.
    struct Level {
        Texture picture;
        Framebuffer target;
        DrawPass down, up;
    };
    void addLevels(const Gpu& gpu, BufferTable& table, const RenderSettings& settings);

    Texture exposed_, developed_;
    Framebuffer exposure_, development_;
    std::vector<Level> levels_;
    DrawPass expose_, develop_;
};

}  // namespace knuckle
