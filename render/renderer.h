#pragma once

#include <memory>

#include "render/image.h"
#include "render/settings.h"
#include "sim/gpu/gpu.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws the particles as spheres straight from the solver's buffers, with the world's colliders around them.
class Renderer {
public:
    /// @throws InputError for a camera that follows an unknown object or an impossible size.
    Renderer(Gpu& gpu, const World& world, const RenderSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws one frame; `time` [s] moves an orbiting camera. Uploads nothing but one small uniform block.
    void draw(const ParticleView& view, double time);
    /// The frame drawn last. Reads back the picture only. Two pixel buffers in turn, so that with `latency` of one
    /// frame the read does not stall.
    Image readImage();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
