#include "sim/solver/fluid/fluid_step.h"

namespace knuckle {

namespace {

constexpr int SETTLING = 48;   // iterations; the pressure of the walls goes about a particle far in each
const Defines STILL{{"SETTLE", "1"}};

}  // namespace

FluidStep::FluidStep(const LoadKernel& load, SolverBuffers& buffers, const Settings& settings)
    : sizes_(buffers.dispatches), hasPool_(buffers.hasPool), confines_(settings.vorticity > 0.0f)
{
    const gpu::StepParameters& p = buffers.parameters;
    slots_ = groupsFor(p.particleCount + p.fluidCount);
    solids_ = groupsFor(p.particleCount);
    fluids_ = groupsFor(p.fluidCount);
    cells_ = groupsFor(p.fluidCellMask + 1);
    chunks_ = groupsFor((p.fluidCellMask + 1) / SCAN_CHUNK);
    const Defines grid{{"FLUIDS", "1"}};
    found_ = load("fluid/fluid_found", {});
    clear_ = load("search/grid_clear", grid);
    count_ = load("search/grid_count", grid);
    sum_ = load("search/scan_sum", grid);
    sumChunks_ = load("search/scan_chunks", grid);
    start_ = load("search/grid_start", grid);
    scatter_ = load("search/grid_scatter", grid);
    order_ = load("fluid/fluid_order", grid);
    find_ = load("fluid/fluid_find", grid);
    near_ = load("fluid/fluid_near", {});
    if (confines_) {
        vorticity_ = load("fluid/fluid_vorticity", {});
        confine_ = load("fluid/fluid_confine", {});
    }
    const Defines tension = buffers.fluid.hasTension ? Defines{{"TENSION", "1"}} : Defines{};
    velocity_ = load("fluid/fluid_velocity", {});
    smooth_ = load("fluid/fluid_smooth", {});
    place_ = load("fluid/fluid_place", {});
    placeSolid_ = load("fluid/fluid_place_solid", {});
    density_ = load("fluid/fluid_density", {});
    push_ = load("fluid/fluid_push", tension);
    react_ = load("fluid/fluid_react", {});
    placeStill_ = load("fluid/fluid_place", STILL);
    placeSolidStill_ = load("fluid/fluid_place_solid", STILL);
    pushStill_ = load("fluid/fluid_push", STILL);
}

void FluidStep::onSlots(KernelTimer& timer, const Kernel& kernel) const
{
    if (hasPool_) kernel.dispatchIndirect(timer, sizes_, DISPATCH_SLOTS);
    else kernel.dispatch(timer, slots_);
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
    onSlots(timer, find_);
    onSlots(timer, near_);
}

void FluidStep::findNeighbours(KernelTimer& timer) const
{
    list(timer);
    onSlots(timer, velocity_);
    place_.dispatch(timer, fluids_);
    onSlots(timer, smooth_);
    if (confines_) {
        onSlots(timer, vorticity_);
        onSlots(timer, confine_);
    }
}

void FluidStep::settle(KernelTimer& timer) const
{
    list(timer);
    placeStill_.dispatch(timer, fluids_);
    placeSolidStill_.dispatch(timer, solids_);
    for (int k = 0; k < SETTLING; ++k) {
        onSlots(timer, density_);
        onSlots(timer, pushStill_);
    }
}

void FluidStep::substep(KernelTimer& timer, bool first) const
{
    if (first) place_.dispatch(timer, fluids_);
    placeSolid_.dispatch(timer, solids_);
    onSlots(timer, density_);
    onSlots(timer, push_);
    react_.dispatch(timer, solids_);
}

}  // namespace knuckle
