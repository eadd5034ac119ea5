#include "sim/solver/shown/shown_stage.h"

#include <algorithm>

#include "sim/world/world.h"

namespace knuckle {

namespace {

/// Steps of a force, over the mean weight of a particle at 9.81 m/s2.
constexpr float UNITS_PER_WEIGHT = 256.0f;

float meanSolidMass(const World& world)
{
    const size_t count = world.particles.size() - world.fluidCount;
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) sum += world.particles[i].mass;
    return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 1.0f;
}

}  // namespace

ShownStage::ShownStage(const StageSetup& setup)
    : parameters_(setup.parameters),
      sums_(setup.world.shown.contactForces && setup.world.settings.solver == SolverKind::Impulse), pairs_(sums_),
      colliders_(sums_ && !setup.world.colliders.empty()), ages_(setup.world.shown.fluidAges)
{
}

void ShownStage::upload(const StageSetup& setup)
{
    gpu::StepParameters& p = setup.parameters;
    // An impulse displaces a mass within a substep.
    const float unit = 9.81f * meanSolidMass(setup.world) / UNITS_PER_WEIGHT;
    p.contactUnit = std::max(unit * p.substepTime * p.substepTime, 1e-30f);
    contactSums = {"contactSums", sums_ ? setup.world.particles.size() : 0};
    contactSums.clear();
    fluidAges = {"fluidAges", ages_ ? setup.world.particles.size() : 0};
    fluidAges.clear();
}

void ShownStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Scratch, contactSums);
    table.add(Lifetime::State, fluidAges);
}

void ShownStage::endStep(Recorder& recorder) const
{
    if (sums_) recorder.perElement(clear_, parameters_.particleCount);
    if (pairs_) recorder.decided(addPairs_, DISPATCH_PAIRS);
    if (colliders_) recorder.decided(addColliders_, DISPATCH_COLLIDER_PAIRS);
    if (ages_) recorder.perElement(age_, parameters_.fluidCount);
}

void ShownStage::show(ParticleView& view) const
{
    if (sums_) view.contactSums = contactSums.id();
    view.contactUnit = parameters_.contactUnit / (parameters_.substepTime * parameters_.substepTime);
    if (ages_) view.fluidAges = fluidAges.id();
}

}  // namespace knuckle
