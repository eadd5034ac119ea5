#pragma once

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"

namespace knuckle {

/// Ropes and cloth in an iteration of the impulse solver: one dispatch a phase, in order.
class DistanceStep {
public:
    DistanceStep() = default;
    DistanceStep(const Gpu& gpu, SolverBuffers& buffers);

    /// @param first whether it is the first iteration of its substep.
    void run(KernelTimer& timer, bool first) const;

private:
    std::vector<DistanceColor> phases_;
    Kernel first_, later_, firstWithBodies_, laterWithBodies_;
};

}  // namespace knuckle
