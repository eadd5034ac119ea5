#pragma once

#include <optional>

#include "render/picture/render_targets.h"
#include "render/settings.h"
#include "render/spheres/sphere_lists.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws listed particles as opaque spheres.
class SpherePass {
public:
    /// @param table must have "frame", "view", "positions", "velocities" and the buffers that SphereLists adds.
    SpherePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
               const RenderTargets& targets);
    SpherePass(const SpherePass&) = delete;
    SpherePass& operator=(const SpherePass&) = delete;

    /// Into the shadow map.
    void drawShadow(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const;
    /// Into the geometry buffers.
    void draw(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const;

private:
    struct Passes {
        DrawPass points, quads, shadow;
    };
    const Passes& of(SphereGroup group) const;

    Buffer<uint32_t> colors_;
    Buffer<gpu::vec4> places_;  ///< In their bodies; empty without patterns.
    Buffer<uint32_t> grains_;   ///< A bit per particle.
    Passes all_;
    std::optional<Passes> beads_;  ///< Of fluids, if others of them are drawn as surfaces.
};

/// gl_PointSize above which spheres are listed as quads [pixels].
float pointSizeLimit();

}  // namespace knuckle
