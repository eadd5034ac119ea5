#pragma once

#include <optional>

#include "sim/solver/fluid/emitter_update.h"
#include "sim/solver/fluid/fluid_step.h"
#include "sim/solver/paper/paper_step.h"
#include "sim/solver/soft/soft_step.h"
#include "sim/solver/rope/distance_step.h"

namespace knuckle {

/// The kernels of a step and the order they run in. Field, file, debug label and timing key are one name.
class Step {
public:
    Step(const Gpu& gpu, SolverBuffers& buffers, const Settings& settings);

    /// Once, before the first step.
    void settle(KernelTimer& timer) const;
    /// Records one Settings::timeStep.
    void run(KernelTimer& timer) const;

private:
    /// One kernel, for bodies and for loose particles.
    struct ForMovers {
        Kernel bodies, loose;
    };
    void dispatch(KernelTimer& timer, const ForMovers& kernels) const;
    void loadSearch(const LoadKernel& load);
    void loadImpulseSolver(const LoadKernel& load);
    void loadRestitution(const LoadKernel& load);
    void loadSleep(const LoadKernel& load);
    void findContacts(KernelTimer& timer) const;
    void impulseSubstep(KernelTimer& timer, bool first) const;
    void bounce(KernelTimer& timer) const;
    void wake(KernelTimer& timer) const;
    void fallAsleep(KernelTimer& timer) const;
    void freeze(KernelTimer& timer) const;
    void paperSubstep(KernelTimer& timer) const;

    Settings settings_;
    bool mayRest_;   ///< Sleep or freeze.
    SolverBuffers& buffers_;
    // Work groups.
    uint32_t particles_, movers_, bodies_, loose_, assemblies_, shared_, sharedByTwo_, sharedByMany_;
    std::optional<FluidStep> fluid_;
    std::optional<FluidPool> fluidPool_;
    // Finding contacts.
    Kernel searchDue_, moverReach_, searchPosition_, searchFarDue_, gridClear_, gridCount_, gridSum_, gridChunks_, gridStart_,
        gridScatter_, gridOrder_, contactFind_, contactFindFar_, colliderNear_, colliderFind_, listSum_, listChunks_,
        listStart_, pairList_, contactPrepare_, colliderPrepare_;
    // The default solver.
    ForMovers moverPredict_, moverSolve_, moverIntegrate_;
    Kernel impulseClear_, moverWarmStart_, contactSolve_, colliderSolve_, jointSolveFirst_, jointSolve_,
        jointSolveManyFirst_, jointSolveMany_, particlePosition_, jointPosition_;
    Kernel contactDetect_, colliderDetect_, contactRestitution_, colliderRestitution_, contactRestitutionEager_,
        colliderRestitutionEager_, moverRestitution_;
    Kernel sleepMover_, sleepIsland_, sleepUpdate_, sleepWakeIsland_, sleepWakeAssembly_, freezeMover_, freezeUpdate_;
    std::optional<SoftStep> soft_;
    DistanceStep distanceStep_;
    std::optional<PaperStep> paper_;
};

}  // namespace knuckle
