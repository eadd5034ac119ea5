#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Fluids that nothing drives only lose energy. If theirs rises by more than solids can have given them, a kernel
/// reports PROBLEM_FLUID_ENERGY.
class FluidWatchStage : public Stage {
public:
    /// For worlds without emitters, drains, clips, moving colliders, wind, fields or vorticity, which may add any
    /// energy.
    static bool isNeeded(const World& world);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Once, before the first step: notes the energy.
    void begin(Recorder& recorder) const;
    /// From now on they may have any energy: a user drives them.
    void allowAll();
    /// Compares the energy with it, at the end of a step.
    void watch(Recorder& recorder) const;

    Buffer<float> fluidEnergySums;    ///< Per GROUP_SIZE fluid particles: kinetic and potential energy [J].
    Buffer<float> fluidEnergyLimits;  ///< The most energy that they may have, and the part of it that is not theirs at
                                      ///< the start [J].

private:
    void sum(Recorder& recorder) const;

    uint32_t fluidCount_ = 0;
    Pass sum_{*this, "fluid/fluid_energy"};
    Pass begin_{*this, "fluid/fluid_energy_limit", {{"START", "1"}}};
    Pass watch_{*this, "fluid/fluid_energy_limit"};
};

}  // namespace knuckle
