#pragma once

#include "sim/gpu/buffer.h"
#include "sim/solver/measure/view_state.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// Buffers that hold a stored state, for drawing it without a solver.
class StoredView {
public:
    /// @param world of the states; must outlive it.
    explicit StoredView(const World& world);
    /// @returns a view that is valid until the next call. @throws std::logic_error for a state of another world.
    ParticleView upload(const ViewState& state);

private:
    const World& world_;
    Buffer<gpu::vec4> positions_, velocities_, centres_, rotations_, colliders_, foam_, distances_;
    Buffer<uint32_t> forms_;
    Buffer<float> ages_, contactForces_;
};

}  // namespace knuckle
