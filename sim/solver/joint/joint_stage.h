#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Joints: particles that bodies share (paper, section 4), as impulses between the bodies.
class JointStage : public Stage {
public:
    explicit JointStage(const StageSetup& setup);
    void addBuffers(BufferTable& table) override;
    /// One for each body of a shared particle.
    static void reserveRows(RowPlan& rows, const World& world, const Layout& layout);

    /// @param first whether it is the first iteration of its substep: joints have no memory.
    void solve(Recorder& recorder, bool first) const;
    /// Shared particles to the mean of where their bodies have them, at the end of a step.
    void placeParticles(Recorder& recorder) const;

    Buffer<uint32_t> sharedParticles;  ///< The particles of two or more bodies.
    Buffer<gpu::uvec4> sharedOwners;   ///< Of those of exactly two, which come first: link and body of each.
    Buffer<uint32_t> linkRows;         ///< Per link: of those of shared particles their row of the channel.

private:
    const gpu::StepParameters& parameters_;
    bool byImpulses_, byTwo_, byMany_;
    Pass solveFirst_{*this, "joint/joint_solve", {{"FIRST_ITERATION", "1"}}, byTwo_};
    Pass solve_{*this, "joint/joint_solve", {}, byTwo_};
    Pass solveManyFirst_{*this, "joint/joint_solve_many", {{"FIRST_ITERATION", "1"}}, byMany_};
    Pass solveMany_{*this, "joint/joint_solve_many", {}, byMany_};
    Pass place_{*this, "joint/joint_position", {}, byTwo_ || byMany_};
};

}  // namespace knuckle
