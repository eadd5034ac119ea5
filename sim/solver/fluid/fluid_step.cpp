#include "sim/solver/fluid/fluid_step.h"

namespace knuckle {

namespace {

constexpr int RELAXATIONS = 48;   // iterations; the pressure of the walls goes about a particle far in each
const Defines RELAXED{{"RELAX", "1"}};

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
    searchPosition_ = load("fluid/fluid_search_position", {});
    clear_ = load("search/grid_clear", grid);
    count_ = load("search/grid_count", grid);
    sum_ = load("search/scan_sum", grid);
    sumChunks_ = load("search/scan_chunks", grid);
    start_ = load("search/grid_start", grid);
    scatter_ = load("search/grid_scatter", grid);
    order_ = load("fluid/fluid_order", grid);
    find_ = load("fluid/fluid_find", grid);
    colliderNear_ = load("fluid/fluid_collider_near", {});
    if (confines_) {
        vorticity_ = load("fluid/fluid_vorticity", {});
        confinement_ = load("fluid/fluid_vorticity_confinement", {});
    }
    const Defines tension = buffers.fluid.hasTension ? Defines{{"TENSION", "1"}} : Defines{};
    gather_ = load("fluid/fluid_gather", {});
    viscosity_ = load("fluid/fluid_viscosity", {});
    predict_ = load("fluid/fluid_predict", {});
    predictSolid_ = load("fluid/fluid_predict_solid", {});
    density_ = load("fluid/fluid_density", {});
    pressure_ = load("fluid/fluid_pressure", tension);
    coupling_ = load("fluid/fluid_solid_coupling", {});
    predictRelaxed_ = load("fluid/fluid_predict", RELAXED);
    predictSolidRelaxed_ = load("fluid/fluid_predict_solid", RELAXED);
    pressureRelaxed_ = load("fluid/fluid_pressure", RELAXED);
}

void FluidStep::onSlots(KernelTimer& timer, const Kernel& kernel) const
{
    if (hasPool_) kernel.dispatchIndirect(timer, sizes_, DISPATCH_SLOTS);
    else kernel.dispatch(timer, slots_);
}

void FluidStep::list(KernelTimer& timer) const
{
    searchPosition_.dispatch(timer, slots_);
    clear_.dispatch(timer, cells_);
    count_.dispatch(timer, slots_);
    sum_.dispatch(timer, chunks_);
    sumChunks_.dispatch(timer, 1);
    start_.dispatch(timer, chunks_);
    scatter_.dispatch(timer, slots_);
    order_.dispatch(timer, slots_);
    onSlots(timer, find_);
    onSlots(timer, colliderNear_);
}

void FluidStep::findNeighbours(KernelTimer& timer) const
{
    list(timer);
    onSlots(timer, gather_);
    predict_.dispatch(timer, fluids_);
    onSlots(timer, viscosity_);
    if (confines_) {
        onSlots(timer, vorticity_);
        onSlots(timer, confinement_);
    }
}

void FluidStep::settle(KernelTimer& timer) const
{
    list(timer);
    predictRelaxed_.dispatch(timer, fluids_);
    predictSolidRelaxed_.dispatch(timer, solids_);
    for (int k = 0; k < RELAXATIONS; ++k) {
        onSlots(timer, density_);
        onSlots(timer, pressureRelaxed_);
    }
}

void FluidStep::substep(KernelTimer& timer, bool first) const
{
    if (first) predict_.dispatch(timer, fluids_);
    predictSolid_.dispatch(timer, solids_);
    onSlots(timer, density_);
    onSlots(timer, pressure_);
    coupling_.dispatch(timer, solids_);
}

}  // namespace knuckle
