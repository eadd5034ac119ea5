#pragma once

#include "sim/gpu/kernel.h"
#include "sim/solver/buffers.h"
#include "sim/world/settings.h"

namespace knuckle {

/// The passes of fluids: position based fluids (Macklin and Mueller 2013) on the particles that stand behind all others.
/// They are no movers; what they press solids with goes through SolverBuffers::particleImpulses.
class FluidStep {
public:
    FluidStep(const LoadKernel& load, SolverBuffers& buffers, const Settings& settings);
    /// Once, before the first step: a lattice that fills a tank is too dense at its walls and at solids, and makes room
    /// there; as part of a step that would make it fast.
    void settle(KernelTimer& timer) const;
    /// Once a step: who is whose neighbour.
    void findNeighbours(KernelTimer& timer) const;
    /// One iteration of pressures, after the movers were predicted; fluid particles are where they end then.
    /// @param first  of the step
    void substep(KernelTimer& timer, bool first) const;

private:
    void list(KernelTimer& timer) const;
    void onSlots(KernelTimer& timer, const Kernel& kernel) const;

    const RawBuffer& sizes_;
    uint32_t slots_, solids_, fluids_, cells_, chunks_;   ///< Work groups.
    bool hasPool_, confines_;   ///< Pool: the GPU decides how many slots there are.
    Kernel searchPosition_, clear_, count_, sum_, sumChunks_, start_, scatter_, order_, find_, colliderNear_;
    Kernel gather_, viscosity_, predict_, predictSolid_, density_, pressure_, coupling_, vorticity_, confinement_;
    Kernel predictRelaxed_, predictSolidRelaxed_, pressureRelaxed_;
};

}  // namespace knuckle
