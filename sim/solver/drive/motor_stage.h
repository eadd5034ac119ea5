#pragma once

#include "shared/motor_types.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Motors and springs of joints (Joint::drive). Like those of DriveStage they are implicit: torques in rows of the
/// channel, computed in each iteration from where the bodies are, and a stiffness in the block of the joint
/// (JointStage::driveStiffness).
class MotorStage : public Stage {
public:
    static bool isNeeded(const World& world);
    explicit MotorStage(const StageSetup& setup) : parameters_(setup.parameters) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;
    /// Reserves a row for each body of a driven joint that may respond.
    static void reserveRows(RowPlan& rows, const World& world, const Layout& layout);

    /// Changes what drives a joint from the next step on. @returns false if nothing drives it.
    bool set(const Layout& layout, uint32_t joint, const TurnDrive& drive);

    /// Before the bodies move: notes how joints are turned.
    void begin(Recorder& recorder) const;
    /// Computes the torques for where the bodies are now; before joints are factored, and in each iteration.
    void turn(Recorder& recorder) const;

    Buffer<gpu::Motor> motors;      ///< And springs of joints.
    Buffer<gpu::vec4> motorStates;  ///< Per motor: how its joint is turned, the change of that.

private:
    const gpu::StepParameters& parameters_;
    Pass begin_{*this, "drive/motor_begin"};
    Pass turn_{*this, "drive/motor_turn"};
};

}  // namespace knuckle
