#pragma once

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"

namespace knuckle {

/// The passes of emitters and drains, which end a step. The host has no part in them: what is due follows from the
/// number of the step.
class FluidPool {
public:
    FluidPool(const LoadKernel& load, SolverBuffers& buffers);
    void run(KernelTimer& timer) const;

private:
    const RawBuffer& sizes_;
    bool hasEmitters_;
    uint32_t chunks_, fluids_;   ///< Work groups.
    Kernel sum_, sumChunks_, pool_, order_, emit_, drain_;
};

}  // namespace knuckle
