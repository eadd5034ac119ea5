#pragma once

#include <memory>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/panes/layout.h"
#include "render/panes/pane.h"

namespace knuckle {

/// Estimates the work of one picture for a software driver, within a factor of three.
Workload drawingWorkload(const RenderSettings& settings);

/// Draws the frames of a film: what the camera of a shot sees, or two of them in one picture, with text over it.
class Renderer {
public:
    /// @throws InputError for a camera that follows an unknown object or a setting out of range.
    /// @throws DeviceError if the device cannot draw at that size.
    Renderer(Gpu& gpu, const World& world, const RenderSettings& settings);
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws one frame and starts the copy of its picture; `time` of the film [s] chooses the shot and moves its
    /// camera. Uploads only one small uniform block.
    /// @throws RunError if the view does not fit the world that the renderer was made for.
    void draw(const ParticleView& view, double time);
    /// One of drawsOf() draws of a frame, from 0 on, each of a moment of its own; with the last the frame is done.
    void expose(const ParticleView& view, double time, uint32_t draw);
    /// Shows a state to the camera without drawing it: a camera that follows or frames moving things remembers its
    /// place, so that a frame looks the same whether or not earlier ones are drawn.
    void look(const ParticleView& view, double time);
    /// From now on the cameras of all shots stand there, whatever they did before: cheap, for a camera that a user
    /// moves. @throws std::logic_error if position and target are nearly equal or not finite.
    void setCamera(const Eigen::Vector3f& position, const Eigen::Vector3f& target);
    /// Where the last frame was drawn or looked at from; waits for it.
    LayerCamera camera() const { return panesAt(time_)[0]->camera(); }
    /// The picture of the last draw(); waits for it. Work dispatched in between runs meanwhile.
    Image readImage();
    /// Stalls until the GPU is done.
    RendererState saveState() const;
    /// @throws std::logic_error if it is not from a renderer of the same kind; then nothing changes.
    void loadState(const RendererState& state);
    /// Times the passes when enabled.
    KernelTimer& timer() { return timer_; }

private:
    /// Of the shot at a time; the first is of its own camera.
    std::vector<Pane*> panesAt(double time) const;

    std::vector<Shot> shots_;
    KernelTimer timer_;
    std::vector<PanePlan> plans_;
    std::vector<std::unique_ptr<Pane>> panes_;  ///< Of the same.
    Overlay overlay_;
    double time_ = 0.0;  ///< Of the last look [s].
};

}  // namespace knuckle
