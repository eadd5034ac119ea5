#pragma once

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"

namespace knuckle {

/// The paper's own solver (section 3): Macklin et al. 2014, algorithm 1, on single particles, to which each body is
/// matched. It predicts, the search for contacts follows, then it solves.
class PaperStep {
public:
    PaperStep(const LoadKernel& load, SolverBuffers& buffers, const Settings& settings);
    void predict(KernelTimer& timer) const;
    /// Stabilization, iterations, velocities and places.
    void solve(KernelTimer& timer) const;

private:
    void loadSums(const LoadKernel& load);
    void stabilize(KernelTimer& timer) const;
    /// Each body to its particles: eqs. 9-18.
    void match(KernelTimer& timer) const;
    /// The sums of eq. 9 by eq. 10.
    void reduceInSteps(KernelTimer& timer) const;

    const SolverBuffers& buffers_;
    Settings settings_;
    uint32_t particles_, bodies_, links_, shared_;   ///< Work groups.
    Kernel predict_, bodyStart_, contactStabilize_, shapeStabilize_, jointStabilize_, contactAverage_,
        bodySum_, linkCentreTerms_, linkMatrixTerms_, linkCentreReduce_, linkMatrixReduce_, bodyCollectCentres_,
        bodyCollectMatrices_, bodyRotation_, shapeGoals_, jointGoals_, finish_;
};

}  // namespace knuckle
