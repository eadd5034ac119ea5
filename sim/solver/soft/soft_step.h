#pragma once

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"

namespace knuckle {

/// The kernels of soft bodies in an iteration, before contacts: clusters are matched to their particles, and pull them.
class SoftStep {
public:
    SoftStep(const LoadKernel& load, const SolverBuffers& buffers);

    /// @param iteration of `count` in the substep, from 0 on.
    void run(KernelTimer& timer, uint32_t iteration, uint32_t count) const;

private:
    uint32_t clusters_, particles_;   ///< Work groups.
    Kernel clusterMatchFirst_, clusterMatch_, clusterPullFirst_, clusterPull_;
};

}  // namespace knuckle
