#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Gears between hinges (World::gears): torques in rows of the channel, which gear_solve corrects in each iteration
/// from how the hinges are turned and how far their trees let a torque turn them. Hinges that gears connect form a
/// train, which turns as one, and which one thread solves.
class GearStage : public Stage {
public:
    static bool isNeeded(const World& world);
    explicit GearStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;
    /// Reserves a row for each body of a geared hinge that may respond.
    static void reserveRows(RowPlan& rows, const World& world, const Layout& layout);

    /// Turns the torques of the substep before with the hinges' axes; before bodies add up what acts on them.
    void begin(Recorder& recorder) const;
    /// Corrects the torques and moves bodies by that; whenever joints have been solved.
    void solve(Recorder& recorder) const;

    Buffer<gpu::uvec2> gearTrains;  ///< First hinge, end.
    Buffer<gpu::GearedHinge> gearHinges;
    Buffer<gpu::vec4> gearStates;    ///< Per hinge, GEAR_STATE_TEXELS: shaders/sim/joint/gears/gear_states.glsl.
    Buffer<float> gearAsked;         ///< Per hinge: the torque that gear_move answers now [kg m2].
    Buffer<uint32_t> gearedHingeOf;  ///< Per joint of the trees, or NO_INDEX.

private:
    const gpu::StepParameters& parameters_;
    Pass begin_{*this, "joint/gears/gear_solve", {{"BEGIN", "1"}}};
    Pass solve_{*this, "joint/gears/gear_solve"};
    Pass move_;
};

}  // namespace knuckle
