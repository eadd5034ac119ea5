#include "sim/solver/fluid/foam_stage.h"

#include <algorithm>

#include "shared/foam_ring.h"
#include "sim/solver/fluid/fluid_numbers.h"
#include "sim/solver/scan.h"

namespace knuckle {

namespace {

constexpr uint32_t LEAST_POINTS = 1024, MOST_POINTS = 200'000;

float foamRate(const Material& material)
{
    return material.viscosity < VISCOUS ? material.look.foam : 0.0f;
}

}  // namespace

uint32_t FoamStage::capacity(const World& world)
{
    const auto foams = [&](const Particle& p) { return foamRate(world.materials[p.material]) > 0.0f; };
    if (std::none_of(world.particles.end() - world.fluidCount, world.particles.end(), foams)) return 0;
    return std::clamp(world.fluidCount, LEAST_POINTS, MOST_POINTS);
}

FoamStage::FoamStage(const StageSetup& setup) : SlotStage(setup) {}

void FoamStage::upload(const StageSetup& setup)
{
    setup.parameters.foamCapacity = capacity(setup.world);
    const size_t points = parameters_.foamCapacity, slots = setup.world.particles.size();
    std::vector<float> rates;
    for (const Material& m : setup.world.materials) rates.push_back(foamRate(m));
    foamRates = {"foamRates", std::span<const float>(rates)};
    foamPlaces = {"foamPlaces", points};
    foamMoves = {"foamMoves", points};
    foamRing = {"foamRing", FOAM_RING_TEXELS};
    foamFlows = {"foamFlows", slots};
    foamFacings = {"foamFacings", slots};
    foamBirths = {"foamBirths", slots};
    foamSums = scanSums("foamSums", slots);
    foamParents = {"foamParents", points / FOAM_BIRTHS_PART};
}

void FoamStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, foamRates);
    table.add(Lifetime::State, foamPlaces, foamMoves, foamRing, foamSums);
    table.add(Lifetime::Scratch, foamFlows, foamFacings, foamBirths, foamParents);
}

void FoamStage::endStep(Recorder& recorder) const
{
    const uint64_t chunks = foamSums.size() - 1;
    perSlot(recorder, surface_);
    perSlot(recorder, births_);
    recorder.perElement(sum_, chunks);
    recorder.groups(ring_, 1);
    recorder.perElement(list_, chunks);
    recorder.decided(advance_, foamRing, FOAM_ADVANCE_SIZE);
    recorder.decided(birth_, foamRing, FOAM_BIRTH_SIZE);
}

}  // namespace knuckle
