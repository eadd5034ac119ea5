#pragma once

#include "sim/solver/measure/measure.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Emitters and drains, which end a step, and the fluid particles that are inactive until an emitter takes them
/// (shaders/sim/emitter/emitters.glsl). The host does nothing: the number of the step says what is due.
class EmitterStage : public Stage {
public:
    static bool isNeeded(const World& world)
    {
        return world.fluidCount > 0 && !(world.emitters.empty() && world.drains.empty());
    }
    explicit EmitterStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    void endStep(Recorder& recorder) const;
    /// Counts of active fluid particles, and of those emitted and drained since the start. Stalls until the GPU is
    /// done.
    void measure(Measures& out) const;

    Buffer<gpu::Emitter> emitters;            ///< What never changes about each.
    Buffer<gpu::EmitterState> emitterStates;  ///< Per emitter, within a step.
    Buffer<gpu::vec4> nozzlePoints;           ///< Where layers leave [m].
    Buffer<uint32_t> poolOrder;               ///< Halves: the particles of each pool, next to leave first.
    Buffer<uint32_t> poolInactive;            ///< Per place in the pool: 1 if it was inactive after the last step.
    Buffer<uint32_t> poolSums, poolChunks;    ///< Per chunk of the pool: inactive particles before it; its emitter.
    Buffer<uint32_t> fluidTotals;             ///< Particles that came, that left.

private:
    void uploadPools(const StageSetup& setup);

    const gpu::StepParameters& parameters_;
    bool hasEmitters_;
    Pass sum_{*this, "common/grid/scan_sum", {{"POOLS", "1"}}, hasEmitters_};
    Pass update_{*this, "emitter/emitter_update"};
    Pass order_{*this, "emitter/pool_order", {}, hasEmitters_};
    Pass emit_;
    Pass drain_{*this, "emitter/fluid_drain"};
};

}  // namespace knuckle
