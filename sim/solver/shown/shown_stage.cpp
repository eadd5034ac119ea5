#include "sim/solver/shown/shown_stage.h"

#include "sim/solver/restitution/restitution_stage.h"

namespace knuckle {

ShownStage::ShownStage(const StageSetup& setup)
    : parameters_(setup.parameters), shown_(setup.world.shown),
      forcesFirst_(*this, "shown/contact_force",
                   definesOf({{"FIRST", true}, {"BOUNCES", RestitutionStage::isNeeded(setup.world)}}),
                   shown_.contactForces),
      forces_(*this, "shown/contact_force", definesOf({{"BOUNCES", RestitutionStage::isNeeded(setup.world)}}),
              shown_.contactForces)
{
}

void ShownStage::upload(const StageSetup& setup)
{
    const size_t count = setup.world.particles.size();
    particleAges = {"particleAges", shown_.ages ? count : 0};
    contactForces = {"contactForces", shown_.contactForces ? count : 0};
}

void ShownStage::addBuffers(BufferTable& table)
{
    if (shown_.ages) table.add(Lifetime::State, particleAges);
    if (shown_.contactForces) table.add(Lifetime::State, contactForces);
}

void ShownStage::addForces(Recorder& recorder, bool first) const
{
    if (shown_.contactForces) recorder.perElement(first ? forcesFirst_ : forces_, parameters_.particleCount);
}

void ShownStage::endStep(Recorder& recorder) const
{
    if (shown_.ages) recorder.perElement(ages_, uint64_t{parameters_.particleCount} + parameters_.fluidCount);
}

void leaveOutUnshown(StagesState& state, const ShownQuantities& shown)
{
    if (!shown.ages) state.buffers.erase("particleAges");
    if (!shown.contactForces) state.buffers.erase("contactForces");
}

}  // namespace knuckle
