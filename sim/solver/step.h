#pragma once

#include <functional>
#include <vector>

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"
#include "sim/solver/strand_step.h"
#include "sim/world/settings.h"

namespace knuckle {

/// The kernels of a step and the order they run in. Field, file, debug label and timing key are one name.
class Step {
public:
    Step(const Gpu& gpu, SolverBuffers& buffers, const Settings& settings);

    /// Records one Settings::timeStep.
    void run(KernelTimer& timer) const;

private:
    /// Compiles a kernel by its name below shaders/sim.
    using Load = std::function<Kernel(const char* name, Defines defines)>;
    void loadSearch(const Load& load);
    void loadImpulseSolver(const Load& load);
    void loadPaperSolver(const Load& load);
    void findContacts(KernelTimer& timer) const;
    void impulseSubstep(KernelTimer& timer) const;
    void paperSubstep(KernelTimer& timer) const;
    void matchShapes(KernelTimer& timer) const;
    void reduceInSteps(KernelTimer& timer) const;

    Settings settings_;
    SolverBuffers& buffers_;
    uint32_t particles_, movers_, bodies_, links_, shared_, sharedByTwo_, sharedByMany_;   ///< Work groups.
    // Finding contacts.
    Kernel findDue_, moverReach_, foundPlace_, fastDue_, gridClear_, gridCount_, gridSum_, gridChunks_, gridStart_,
        gridScatter_, gridOrder_, contactFind_, contactFindFar_, colliderNear_, colliderFind_, listSum_, listChunks_,
        listStart_, pairList_, pairWrite_, colliderWrite_;
    // The default solver.
    Kernel moverPredict_, impulseClear_, moverWarm_, contactSolve_, colliderSolve_, jointSolveFirst_, jointSolve_,
        jointSolveManyFirst_, jointSolveMany_, moverSolve_, moverFinish_, particlePlace_, jointPlace_;
    StrandStep strandStep_;
    // The paper's.
    Kernel predict_, bodyStart_, contactStabilize_, stabilizeApply_, contactAverage_, bodySum_, linkCentreTerms_,
        linkMatrixTerms_, linkReduce_, bodyCollectCentres_, bodyCollectMatrices_, bodyRotation_, shapeGoals_,
        jointGoals_, finish_;
};

}  // namespace knuckle
