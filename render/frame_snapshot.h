#pragma once

#include "render/settings.h"
#include "sim/gpu/buffer.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// A copy of what a renderer reads of a state, made on the device, so that another context can draw it while the solver
/// goes on. Lives in the solver's context; its two sides may be called on different threads, one at a time.
class FrameSnapshot {
public:
    /// @param world, settings of what is drawn from it: they say what of a state is read.
    FrameSnapshot(const World& world, const RenderSettings& settings);
    /// On the solver's side: copies, after whatever was drawn from the copy before.
    void take(const ParticleView& view);
    /// On the drawing side: the copy, which what is drawn from now on finds complete.
    const ParticleView& begin();
    /// On the drawing side: all that reads the copy has been sent off.
    void end();

private:
    /// Whose end the other context waits for on the device.
    class Fence {
    public:
        Fence() = default;
        ~Fence();
        Fence(const Fence&) = delete;
        Fence& operator=(const Fence&) = delete;
        void set();
        void wait();

    private:
        GLsync sync_ = nullptr;
    };

    bool showsSpeeds_, showsCentres_, showsSkins_;
    RawBuffer positions_, velocities_, centres_, rotations_, colliders_;
    ParticleView view_;
    Fence taken_, drawn_;
};

}  // namespace knuckle
