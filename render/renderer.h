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

/// About what one picture asks of a software driver, within three times.
Workload drawingWorkload(const RenderSettings& settings);

/// All that a renderer carries from one frame to the next: where a camera that follows or frames what moves was. Of the
/// same World and settings, program and driver, it goes on with the same pictures.
struct RendererState {
    std::optional<double> lookedAt;  ///< Time of the state that the camera saw last [s].
    BufferState buffers;
};

/// Draws the particles as spheres, and skins, straight from the solver's buffers, with the world's colliders around
/// them.
class Renderer {
public:
    /// @throws InputError for a camera that follows an unknown object or a setting out of range.
    /// @throws DeviceError when the device cannot draw at that size.
    Renderer(Gpu& gpu, const World& world, const RenderSettings& settings);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws one frame and starts the copy of its picture; `time` [s] moves the camera. Uploads nothing but one
    /// small uniform block. @throws RunError when the view does not fit the world that the renderer was made for.
    void draw(const ParticleView& view, double time);
    /// Shows a state to the camera without drawing it: one that follows or frames what moves remembers where it was, so
    /// that a frame looks the same with and without those before.
    void look(const ParticleView& view, double time);
    /// The picture of the last draw(); waits for it. What is dispatched in between runs meanwhile.
    Image readImage();
    /// Stalls until the GPU is done.
    RendererState saveState() const;
    /// @throws std::logic_error where it is not of a renderer of the same kind; nothing has changed then.
    void loadState(const RendererState& state);
    /// Times its passes once it is enabled.
    KernelTimer& timer();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
