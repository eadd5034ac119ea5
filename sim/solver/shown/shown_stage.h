#pragma once

#include "sim/solver/stage.h"
#include "sim/solver/stages_state.h"

namespace knuckle {

/// Numbers of particles that pictures alone show (World::shown), and that no other room keeps.
class ShownStage : public Stage {
public:
    static bool isNeeded(const World& world) { return world.shown.ages || world.shown.contactForces; }
    explicit ShownStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// At the end of each substep. @param first of a step.
    void addForces(Recorder& recorder, bool first) const;
    /// Before fluid comes and goes.
    void endStep(Recorder& recorder) const;

    Buffer<float> particleAges;   ///< Per particle, if shown: time since it came into the scene [s].
    Buffer<float> contactForces;  ///< Per particle, if shown: sum of the sizes of the forces of its contacts with
                                  ///< particles and colliders, mean over the step [N]; 0 of fluids.

private:
    const gpu::StepParameters& parameters_;
    ShownQuantities shown_;
    Pass forcesFirst_, forces_;
    Pass ages_{*this, "shown/particle_age", {}, shown_.ages};
};

/// Takes what a world does not show out of a state of the same world that did.
void leaveOutUnshown(StagesState& state, const ShownQuantities& shown);

}  // namespace knuckle
