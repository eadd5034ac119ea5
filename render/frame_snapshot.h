#pragma once

#include "render/settings.h"
#include "sim/gpu/buffer.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// A copy of the state that a renderer reads, made on the device, so that another context can draw it while the solver
/// continues. Lives in the solver's context; its two sides may be called on different threads, one at a time.
class FrameSnapshot {
public:
    /// @param world, pictures that are drawn of it: they determine what is copied.
    FrameSnapshot(const World& world, const std::vector<RenderSettings>& pictures);
    /// On the solver's side: copies, after all drawing from the last copy.
    void take(const ParticleView& view);
    /// On the drawing side: the copy, complete for all later draw calls.
    const ParticleView& begin();
    /// On the drawing side: to be called after the last draw call that reads the copy.
    void end();

private:
    void takeSlots(const ParticleView& view);

    /// A fence that the other context waits for on the device.
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

    bool showsSpeeds_, showsRotations_, showsCentres_, showsSlots_;
    RawBuffer positions_, velocities_, centres_, rotations_, colliders_, foam_, forms_, distances_;
    RawBuffer particleSlots_, slotParticles_, pressures_, shapes_, covers_, ages_, contactForces_;
    ParticleView view_;
    Fence taken_, drawn_;
};

}  // namespace knuckle
