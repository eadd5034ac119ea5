#pragma once

#include "sim/solver/particle_view.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// What only pictures ask for (World::shown): how hard contacts press on each particle, and how old fluid is. Nothing of
/// the simulation depends on it.
class ShownStage : public Stage {
public:
    static bool isNeeded(const World& world) { return world.shown.contactForces || world.shown.fluidAges; }
    explicit ShownStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// After fluid has come and gone.
    void endStep(Recorder& recorder) const;
    /// Adds its buffers to a view.
    void show(ParticleView& view) const;

    Buffer<uint32_t> contactSums;  ///< Per particle: normal force of its contacts, in units of StepParameters::contactUnit.
    Buffer<float> fluidAges;       ///< Per particle of a fluid: since it came [s].

private:
    const gpu::StepParameters& parameters_;
    bool sums_, pairs_, colliders_, ages_;
    Pass clear_{*this, "shown/force_clear", {}, sums_};
    Pass addPairs_{*this, "shown/force_sum", {}, pairs_};
    Pass addColliders_{*this, "shown/force_sum", {{"COLLIDERS", "1"}}, colliders_};
    Pass age_{*this, "shown/fluid_age", {}, ages_};
};

}  // namespace knuckle
