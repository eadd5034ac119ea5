#pragma once

#include <optional>

#include "render/fluids/underwater_pass.h"
#include "render/picture/render_targets.h"
#include "render/settings.h"
#include "render/spheres/sphere_lists.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws fluids as surfaces: the depth of their spheres, smoothed, over the lit picture of all else.
class FluidPass {
public:
    /// @param table must have "frame", "view", "positions", "foamPlaces", the targets' textures and the buffers of
    /// FluidLooks,
    /// SphereLists and SpherePass.
    FluidPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
              RenderTargets& targets);
    FluidPass(const FluidPass&) = delete;
    FluidPass& operator=(const FluidPass&) = delete;

    bool empty() const { return count_ == 0; }
    /// Into the shadow map of fluids, what they dim of the light, and what their surface gathers of it.
    void drawShadow(KernelTimer& timer, const SphereLists& lists) const;
    /// The surface's depth, and what light meets inside.
    void drawDepth(KernelTimer& timer, const SphereLists& lists);
    /// After lighting and drawDepth(): changes the lit picture.
    /// @param foamCount  Points of foam, spray and bubbles.
    void shade(KernelTimer& timer, uint32_t foamCount);
    /// Of layers: their surface into the geometry buffers, after all else.
    void drawLayer(KernelTimer& timer, const SphereLists& lists);

private:
    /// The depth of the nearest fluid.
    void drawFront(KernelTimer& timer, const SphereLists& lists);
    /// That of its surface.
    void smooth(KernelTimer& timer) const;
    void loadDims(const Gpu& gpu, BufferTable& table);
    /// How many particles each one stands for in the map of what fluids dim.
    uint32_t dimsStride() const;
    void loadShading(const Gpu& gpu, const BufferTable& table, const RenderSettings& settings);
    void loadFoam(const Gpu& gpu, const BufferTable& table, const RenderSettings& settings);
    void drawFoam(KernelTimer& timer, uint32_t count);

    RenderTargets& targets_;
    uint32_t count_;
    std::optional<UnderwaterPass> underwater_;
    Texture dimsPicture_;  ///< What fluid dims of the key light (fluid_dims.frag).
    Framebuffer dimsMap_;
    DrawPass points_, quads_, shadow_, dims_, bends_, focus_, tint_, rows_, columns_, clean_, shade_, foam_, foamShade_,
        layer_;
};

}  // namespace knuckle
