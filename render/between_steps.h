#pragma once

#include "shared/frame_types.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/gpu.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/measure/view_state.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// What is drawn between two steps, for slow motion: on the device, particles on cubics through their places and
/// velocities at both, bodies and colliders turned evenly. The simulation knows nothing of it.
class BetweenSteps {
public:
    /// @param world of the views; must outlive it.
    BetweenSteps(const Gpu& gpu, const World& world);
    BetweenSteps(const BetweenSteps&) = delete;
    BetweenSteps& operator=(const BetweenSteps&) = delete;

    /// Copies the state before a step.
    void begin(const ParticleView& before);
    /// @param after the step. @param part of the step, 0 ... 1. @returns a view that is valid until the next call.
    ParticleView at(const ParticleView& after, double part);
    /// Fills in what at() has made; stalls until the GPU is done.
    void read(ViewState& view) const;
    /// The state before the step.
    BufferState saveState() const { return table_.saveState(); }
    /// @throws std::logic_error for a state of another world.
    void loadState(const BufferState& state) { table_.loadState(state); }

private:
    /// One array of a view: before the step, after it, and between.
    struct Array {
        GLuint ParticleView::*name;
        std::vector<gpu::vec4> ViewState::*values;
        Buffer<gpu::vec4> before, between;
        RawBuffer after;  ///< Stands in for the view's.
    };
    void addArray(const char* label, size_t size, GLuint ParticleView::*name,
                  std::vector<gpu::vec4> ViewState::*values);

    const World& world_;
    std::vector<Array> arrays_;
    Buffer<gpu::BetweenInput> input_{"between", 1};
    BufferTable table_;
    Kernel places_, poses_;
    KernelTimer timer_;
};

}  // namespace knuckle
