#pragma once

#include <memory>
#include <optional>

#include "render/picture/image.h"
#include "render/settings.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/gpu.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// Estimates the work of one picture for a software driver, within a factor of three.
Workload drawingWorkload(const RenderSettings& settings);

/// All that a renderer carries from one frame to the next: the last place of a camera that follows or frames moving
/// things. With the same World, settings, program and driver, a renderer that loads it continues with the same
/// pictures.
struct RendererState {
    std::optional<double> lookedAt;  ///< Time of the film at the camera's last look [s].
    BufferState buffers;
};

/// Draws particles as spheres, shapes of bodies, and skins, directly from the solver's buffers, with the world's
/// colliders around them.
class Renderer {
public:
    /// @throws InputError for a camera that follows an unknown object or a setting out of range.
    /// @throws DeviceError if the device cannot draw at that size.
    Renderer(Gpu& gpu, const World& world, const RenderSettings& settings);
    ~Renderer();
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
    /// The picture of the last draw(); waits for it. Work dispatched in between runs meanwhile.
    Image readImage();
    /// Stalls until the GPU is done.
    RendererState saveState() const;
    /// @throws std::logic_error if it is not from a renderer of the same kind; then nothing changes.
    void loadState(const RendererState& state);
    /// Times the passes when enabled.
    KernelTimer& timer();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
