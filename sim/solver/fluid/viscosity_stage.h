#pragma once

#include "sim/solver/fluid/slot_stage.h"

namespace knuckle {

/// Implicit viscosity, of worlds that have a viscous fluid (isViscous()): after the pressures of a substep, velocities
/// are solved for that viscosity leaves at its end.
class ViscosityStage : public SlotStage {
public:
    static bool isNeeded(const World& world);
    explicit ViscosityStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;
    void makeLists() override;

    /// Before the pressures of a substep.
    void begin(Recorder& recorder) const;
    /// After them.
    void solve(Recorder& recorder) const;

    Buffer<gpu::vec4> viscousMaterials;           ///< Per material: thickness, grips of walls and solids, slip.
    Buffer<uint32_t> viscousStiffness;            ///< One: largest eigenvalue of viscosity, as bits of a float.
    Buffer<gpu::vec4> slotStarts;                 ///< When the substep began [m]; w: grip of solids [kg/m2].
    Buffer<gpu::vec4> slotGoals;                  ///< Velocity without viscosity [m/s]; w: 1/mass.
    Buffer<gpu::vec4> slotGrips;                  ///< Velocity of the wall that it sticks to [m/s]; w: how hard [kg].
    Buffer<gpu::vec4> slotFlows, slotOtherFlows;  ///< Iterates of its velocity [m/s]; w: thickness [kg/m2].

private:
    uint32_t sweeps_ = 0;  ///< Of each half of the solve.
    Pass begin_{*this, "fluid/viscous/viscous_begin"};
    Pass movers_{*this, "fluid/viscous/viscous_movers"};
    Pass start_{*this, "fluid/viscous/viscous_start"};
    Pass stiffness_{*this, "fluid/viscous/viscous_stiffness"};
    Pass sweep_{*this, "fluid/viscous/viscous_sweep"};
    Pass sweepBack_{*this, "fluid/viscous/viscous_sweep", {{"BACK", "1"}}};
    Pass end_{*this, "fluid/viscous/viscous_end"};
};

}  // namespace knuckle
