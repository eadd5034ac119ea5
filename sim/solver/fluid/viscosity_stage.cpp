#include "sim/solver/fluid/viscosity_stage.h"

#include <algorithm>

#include "sim/solver/fluid/fluid_numbers.h"

namespace knuckle {

bool ViscosityStage::isNeeded(const World& world)
{
    return world.fluidCount > 0 && std::ranges::any_of(world.materials, isViscous);
}

ViscosityStage::ViscosityStage(const StageSetup& setup) : SlotStage(setup) {}

void ViscosityStage::upload(const StageSetup& setup)
{
    gpu::StepParameters parameters = setup.parameters;  // the stage of fluids may set its own later
    setFluidParameters(parameters, setup.world);
    std::vector<gpu::vec4> materials;
    for (const Material& m : setup.world.materials) materials.push_back(viscousMaterial(parameters, m));
    viscousMaterials = {"viscousMaterials", std::span<const gpu::vec4>(materials)};
    viscousStiffness = {"viscousStiffness", 1};
    sweeps_ = viscousSweeps(parameters, setup.world);
}

void ViscosityStage::makeLists()
{
    const size_t count = parameters_.particleCount + parameters_.fluidCount;
    slotStarts = {"slotStarts", count};
    slotGoals = {"slotGoals", count};
    slotGrips = {"slotGrips", count};
    slotFlows = {"slotFlows", count};
    slotOtherFlows = {"slotOtherFlows", count};
}

void ViscosityStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, viscousMaterials);
    table.add(Lifetime::State, viscousStiffness);  // it begins a substep with zero
    table.add(Lifetime::Scratch, slotStarts, slotGoals, slotGrips, slotFlows, slotOtherFlows);
}

void ViscosityStage::begin(Recorder& recorder) const
{
    perSlot(recorder, begin_);
}

void ViscosityStage::solve(Recorder& recorder) const
{
    recorder.perElement(movers_, parameters_.moverCount);
    perSlot(recorder, start_);
    perSlot(recorder, stiffness_);
    // The second half starts anew from what the first has found: what is left of an error is then a square, and never
    // has the other sign. Else pressures would drive some motions instead of damping them.
    for (uint32_t k = 0; k < 2 * sweeps_; ++k) {
        const Kernel& sweep = k % 2 == 0 ? sweep_ : sweepBack_;
        glProgramUniform1f(sweep.program(), 0, static_cast<float>(k % sweeps_));
        perSlot(recorder, sweep);
    }
    perSlot(recorder, end_);
}

}  // namespace knuckle
