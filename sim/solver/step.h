#pragma once

#include <optional>

#include "sim/solver/fluid/fluid_pool.h"
#include "sim/solver/fluid/fluid_step.h"
#include "sim/solver/paper/paper_step.h"
#include "sim/solver/soft/soft_step.h"
#include "sim/solver/rope/strand_step.h"

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
    void loadBounces(const LoadKernel& load);
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
    Kernel findDue_, moverReach_, foundPlace_, fastDue_, gridClear_, gridCount_, gridSum_, gridChunks_, gridStart_,
        gridScatter_, gridOrder_, contactFind_, contactFindFar_, colliderNear_, colliderFind_, listSum_, listChunks_,
        listStart_, pairList_, pairWrite_, colliderWrite_;
    // The default solver.
    ForMovers moverPredict_, moverSolve_, moverFinish_;
    Kernel impulseClear_, moverWarm_, contactSolve_, colliderSolve_, jointSolveFirst_, jointSolve_,
        jointSolveManyFirst_, jointSolveMany_, particlePlace_, jointPlace_;
    Kernel contactCollide_, colliderCollide_, contactBounce_, colliderBounce_, contactBounceEagerly_,
        colliderBounceEagerly_, moverBounce_;
    Kernel sleepMover_, sleepPair_, sleepSettle_, sleepWake_, sleepRouse_, freezeMover_, freezeSettle_;
    std::optional<SoftStep> soft_;
    StrandStep strandStep_;
    std::optional<PaperStep> paper_;
};

}  // namespace knuckle
