#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sim/solver/solver.h"

namespace knuckle {

/// A Solver on the device of its thread, which counts its steps and checks their lists: what other programs step.
/// Solvers of a thread share its device, which lives while any of them does.
class SteppedSolver {
public:
    /// @param world must outlive it. @param device as `--device`; the first of a thread chooses for all.
    /// @throws DeviceError, InputError as Gpu and Solver; std::logic_error for another device than the thread's.
    SteppedSolver(const World& world, const std::string& device);

    /// The solver, for calls from the thread that made it. @throws std::logic_error from another.
    Solver& here();
    Gpu& gpu() const { return *gpu_; }
    /// Advances by `count` steps. @throws as Solver::checkCounters().
    void step(uint32_t count);
    uint64_t steps() const { return steps_; }
    /// Since the start [s].
    double time() const;
    /// @param steps at which the state was saved. @throws as Solver::loadState().
    void load(const SolverState& state, uint64_t steps);

private:
    const World& world_;
    std::shared_ptr<Gpu> gpu_;
    Solver solver_;
    uint64_t steps_ = 0;
    uint64_t thread_;  ///< The number of that which made it.
};

}  // namespace knuckle
