#pragma once

#include <vector>

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"
#include "sim/world/settings.h"

namespace knuckle {

/// The kernels of a step and the order they run in. Field, file, debug label and timing key are one name.
class Step {
public:
    Step(const Gpu& gpu, SolverBuffers& buffers, const Settings& settings);

    /// Records one Settings::timeStep.
    void run(KernelTimer& timer) const;

private:
    void substep(KernelTimer& timer) const;
    void findContacts(KernelTimer& timer) const;
    void impulseIterations(KernelTimer& timer) const;
    void paperIterations(KernelTimer& timer) const;
    void matchShapes(KernelTimer& timer, bool last) const;
    void reduceInSteps(KernelTimer& timer) const;

    Settings settings_;
    SolverBuffers& buffers_;
    uint32_t particles_, bodies_, links_, shared_;   ///< Work groups.
    Kernel predict_, findDue_, gridClear_, gridCount_, gridChunkSum_, gridChunkScan_, gridCellStart_, gridScatter_,
        gridOrder_, contactFind_, colliderFind_;
    Kernel contactWarm_, contactSolve_, contactAverage_, contactStabilize_, stabilizeApply_;
    Kernel bodyStart_, bodySum_, linkCentreTerms_, linkMatrixTerms_, linkReduce_, bodyCollectCentres_,
        bodyCollectMatrices_, bodyRotation_;
    Kernel shapeGoals_, jointGoals_, jointGoalsLast_, finish_;
};

}  // namespace knuckle
