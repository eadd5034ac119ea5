#pragma once

#include <memory>
#include <optional>

#include "render/layers/layers.h"
#include "render/picture/image.h"
#include "render/settings.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/gpu.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// All that a renderer carries from one frame to the next: the last place of a camera that follows or frames moving
/// things. With the same World, settings, program and driver, a renderer that loads it continues with the same
/// pictures.
struct RendererState {
    std::optional<double> lookedAt;  ///< Time of the film at the camera's last look [s].
    BufferState buffers;
};

/// What one camera at a time sees: a frame, or a part of one. Draws particles as spheres, shapes of bodies, and skins,
/// directly from the solver's buffers, with the world's colliders around them. Members are as those of Renderer.
class Pane {
public:
    /// @param settings with the cameras of this pane; text over the picture is none of its business.
    /// @param timer of the passes; must outlive it.
    Pane(Gpu& gpu, const World& world, const RenderSettings& settings, KernelTimer& timer);
    ~Pane();
    Pane(const Pane&) = delete;
    Pane& operator=(const Pane&) = delete;

    void draw(const ParticleView& view, double time);
    void expose(const ParticleView& view, double time, uint32_t draw);
    void look(const ParticleView& view, double time);
    /// All its cameras stand there from now on. @throws as Camera::stand().
    void setCamera(const Eigen::Vector3f& position, const Eigen::Vector3f& target);
    /// Of the last look or draw; waits for it.
    LayerCamera camera() const;
    Image readImage();
    /// At the depth of what the camera aims at; waits for the frame.
    float pixelsPerMetre() const;
    /// Of a pane whose settings are layerSettings(): layers instead of pictures. Stalls until the GPU is done.
    Layers drawLayers(const ParticleView& view, double time);
    /// Shows a state to the camera and to the layers of the next frame.
    LayerCamera lookForLayers(const ParticleView& view, double time);
    RendererState saveState() const;
    void loadState(const RendererState& state);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
