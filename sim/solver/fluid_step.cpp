#include "sim/solver/fluid_step.h"

namespace knuckle {

namespace {

constexpr int SETTLING = 48;   // iterations; the pressure of the walls goes about a particle far in each
const Defines STILL{{"SETTLE", "1"}};

}  // namespace

FluidStep::FluidStep(const LoadKernel& load, SolverBuffers& buffers, const Settings& settings)
{
    const gpu::StepParameters& p = buffers.parameters;
    slots_ = groupsFor(p.particleCount + p.fluidCount);
    cells_ = groupsFor(p.cellMask + 1);
    chunks_ = groupsFor((p.cellMask + 1) / SCAN_CHUNK);
    Defines grid{{"FLUIDS", "1"}};
    if (settings.grid == GridKind::Hash) grid.push_back({"GRID_HASH", "1"});
    found_ = load("fluid_found", {});
    clear_ = load("grid_clear", grid);
    count_ = load("grid_count", grid);
    sum_ = load("scan_sum", grid);
    sumChunks_ = load("scan_chunks", grid);
    start_ = load("grid_start", grid);
    scatter_ = load("grid_scatter", grid);
    order_ = load("fluid_order", grid);
    find_ = load("fluid_find", grid);
    near_ = load("fluid_near", {});
    velocity_ = load("fluid_velocity", {});
    smooth_ = load("fluid_smooth", {});
    place_ = load("fluid_place", {});
    density_ = load("fluid_density", {});
    push_ = load("fluid_push", {});
    react_ = load("fluid_react", {});
    placeStill_ = load("fluid_place", STILL);
    pushStill_ = load("fluid_push", STILL);
}

void FluidStep::list(KernelTimer& timer) const
{
    found_.dispatch(timer, slots_);
    clear_.dispatch(timer, cells_);
    count_.dispatch(timer, slots_);
    sum_.dispatch(timer, chunks_);
    sumChunks_.dispatch(timer, 1);
    start_.dispatch(timer, chunks_);
    scatter_.dispatch(timer, slots_);
    order_.dispatch(timer, slots_);
    find_.dispatch(timer, slots_);
    near_.dispatch(timer, slots_);
}

void FluidStep::findNeighbours(KernelTimer& timer) const
{
    list(timer);
    velocity_.dispatch(timer, slots_);
    place_.dispatch(timer, slots_);
    smooth_.dispatch(timer, slots_);
}

void FluidStep::settle(KernelTimer& timer) const
{
    list(timer);
    for (int k = 0; k < SETTLING; ++k) {
        placeStill_.dispatch(timer, slots_);
        density_.dispatch(timer, slots_);
        pushStill_.dispatch(timer, slots_);
    }
}

void FluidStep::substep(KernelTimer& timer) const
{
    place_.dispatch(timer, slots_);
    density_.dispatch(timer, slots_);
    push_.dispatch(timer, slots_);
    react_.dispatch(timer, slots_);
}

}  // namespace knuckle
