#pragma once

#include "render/draw_pass.h"
#include "render/marks/mark_pen.h"
#include "render/picture/render_targets.h"

namespace knuckle {

/// Draws marks over the lit picture, in front of everything.
class MarkPass {
public:
    /// @param table must have "frame", "view", "bodyCentres" and "bodyRotations".
    /// @param shown what shaders are compiled with that write displayed colours.
    MarkPass(const Gpu& gpu, BufferTable& table, const Marks& marks, const RenderTargets& targets,
             const Defines& shown);
    MarkPass(const MarkPass&) = delete;
    MarkPass& operator=(const MarkPass&) = delete;

    void draw(KernelTimer& timer) const;

private:
    Buffer<gpu::vec4> corners_;  ///< Of fans, then of lines.
    uint32_t fanCorners_, lineCorners_;
    DrawPass fans_, lines_;
};

}  // namespace knuckle
