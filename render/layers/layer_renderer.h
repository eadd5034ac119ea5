#pragma once

#include "render/layers/layers.h"
#include "render/panes/pane.h"

namespace knuckle {

/// Draws the frames of a film as numbers.
class LayerRenderer {
public:
    /// @throws as Renderer.
    LayerRenderer(Gpu& gpu, const World& world, const RenderSettings& settings);

    /// Shows a state without drawing it: a camera that moves by itself, and what frames know of the one before them,
    /// need every frame. @param time of the film [s].
    LayerCamera look(const ParticleView& view, double time);
    /// As Renderer::setCamera().
    void setCamera(const Eigen::Vector3f& position, const Eigen::Vector3f& target)
    {
        pane_.setCamera(position, target);
    }
    /// Stalls until the GPU is done.
    Layers draw(const ParticleView& view, double time);

private:
    KernelTimer timer_;
    Pane pane_;
};

}  // namespace knuckle
