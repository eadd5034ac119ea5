#pragma once

#include "render/draw_pass.h"
#include "render/picture/render_targets.h"
#include "render/picture/sided_pass.h"
#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws the shapes of bodies, ray-cast inside boxes, where the solver has the bodies.
class ShapePass {
public:
    /// Adds "bodyShapes" to the table, which must have "frame", "view", "velocities", "bodyCentres" and
    /// "bodyRotations".
    ShapePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
              const RenderTargets& targets);
    ShapePass(const ShapePass&) = delete;
    ShapePass& operator=(const ShapePass&) = delete;

    /// Into the shadow map.
    void drawShadow(KernelTimer& timer) const
    {
        draw(timer, shadow_, opaqueCount_);
        draw(timer, glassShadow_, glassCount_);
    }
    /// Into the geometry buffers.
    void draw(KernelTimer& timer) const { draw(timer, shapes_, opaqueCount_); }
    bool hasGlass() const { return glassCount_ > 0; }
    /// Over the lit picture, into the target for glass.
    void drawGlass(KernelTimer& timer, FluidSide side) const { draw(timer, glass_.of(side), glassCount_); }

private:
    static void draw(KernelTimer& timer, const DrawPass& pass, uint32_t count);

    Buffer<gpu::vec4> bodyShapes_;  ///< SHAPE_TEXELS each, of those that are not unseen; those of glass last.
    uint32_t opaqueCount_ = 0, glassCount_ = 0;
    DrawPass shapes_, shadow_, glassShadow_;
    SidedPass glass_;
};

}  // namespace knuckle
