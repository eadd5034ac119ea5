#include "sim/solver/fluid/fluid_stage.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "shared/slot_lists.h"
#include "sim/base/errors.h"
#include "sim/solver/fluid/fluid_numbers.h"
#include "sim/solver/scan.h"

namespace knuckle {

namespace {

/// Passes between two checks of the remaining push: in each, wall pressure spreads by about a particle.
constexpr int RELAXATIONS = 24;
/// Most checks: more would not help if nothing can get out, as in a closed box that is too full.
constexpr int MOST_LOOKS = 80;
/// Fluid is at rest when no particle would start faster than this [m/s].
constexpr float STARTS_WITH = 0.02f;
/// Looks while weight settles: few if something falls, which would come down by a fifth of a rest distance in them,
/// more in a tank, whose surface has to sink by what its weight presses together.
constexpr int LEAST_SETTLING = 3, MOST_SETTLING = 6;
/// Moves of a pass by which that is told, over what weight gives in it.
constexpr float SETTLED = 0.5f, FALLING = 5.0f;
/// Of Settings::vorticity: at 1, swirls lose nearly nothing.
constexpr float VORTICITY = 0.12f;
/// Substeps between two looks at the shapes of neighbourhoods.
constexpr uint32_t SHAPE_SUBSTEPS = 8;

bool settlesIn(const World& world)
{
    return !world.settings.gravity.isZero() && std::ranges::none_of(world.materials, isViscous);
}

bool hasTensionIn(const World& world)
{
    return std::ranges::any_of(world.materials, [](const Material& m) { return m.surfaceTension > 0.0f; });
}

}  // namespace

FluidStage::FluidStage(const StageSetup& setup)
    : SlotStage(setup), confines_(setup.world.settings.vorticity > 0.0f), hasTension_(hasTensionIn(setup.world)),
      hasColliders_(!setup.world.colliders.empty()), hasSolids_(setup.layout.solidCount > 0),
      seals_(!setup.world.bodies.empty() && !setup.world.colliders.empty()), settles_(settlesIn(setup.world))
{
}

void FluidStage::adapt(gpu::StepParameters& parameters)
{
    setQuietSpeed(parameters);
}

void FluidStage::upload(const StageSetup& setup)
{
    const Settings& settings = setup.world.settings;
    setup.parameters.vorticity = VORTICITY * settings.vorticity * settings.timeStep;
    setFluidParameters(setup.parameters, setup.world);
    const size_t cells = parameters_.fluidCellMask + 1;
    fluidCellCounts = {"fluidCellCounts", cells};
    fluidCellSums = scanSums("fluidCellSums", cells);
    std::vector<gpu::vec4> materials;
    for (const Material& m : setup.world.materials)
        materials.push_back(fluidMaterial(parameters_, m, settings.timeStep));
    fluidMaterials = {"fluidMaterials", std::span<const gpu::vec4>(materials)};
    fluidLargestPush = {"fluidLargestPush", 1};
    particleWets = {"particleWets", seals_ ? 3 * parameters_.particleCount : 0};
    bodySeals = {"bodySeals", seals_ ? parameters_.bodyCount : 0};
    slotListSizes = {"slotListSizes", SLOT_LISTS};
    fluidPasts = {"fluidPasts", parameters_.particleCount + parameters_.fluidCount};
}

void FluidStage::makeLists()
{
    const gpu::StepParameters& p = parameters_;
    const size_t count = p.particleCount + p.fluidCount, cells = p.fluidCellMask + 1;
    const size_t slots = (count + NEIGHBOUR_BLOCK - 1) / NEIGHBOUR_BLOCK * NEIGHBOUR_BLOCK;
    fluidSearchPositions = {"fluidSearchPositions", count};
    fluidParticleCells = {"fluidParticleCells", count};
    fluidCellStarts = {"fluidCellStarts", cells + WRAPPED_CELLS + 1};
    fluidCellMembers = {"fluidCellMembers", count};
    fluidNearSolids = {"fluidNearSolids", hasSolids_ ? cells / (32 * FINE_CELLS) : 0};
    fluidSorted = {"fluidSorted", (2 * count + 3) / 4 * 4};
    slotParticles = {"slotParticles", count};
    particleSlots = {"particleSlots", count};
    slotCounts = {"slotCounts", count};
    slotNeighbours = {"slotNeighbours", p.fluidSlots / 4 * slots};
    slotColliders = {"slotColliders", count};
    freeSlots = {"freeSlots", count};
    walledSlots = {"walledSlots", count};
    coveredSlots = {"coveredSlots", count};
    slotMaterials = {"slotMaterials", count};
    slotVelocities = {"slotVelocities", count};
    slotGradients = {"slotGradients", count};
    slotPositions = {"slotPositions", count};
    slotMoves = {"slotMoves", count};
    slotShapes = {"slotShapes", 2 * count};
    slotPressures = {"slotPressures", 2 * count};
    slotVorticities = {"slotVorticities", confines_ ? count : 0};
    slotWalls = {"slotWalls", count};
    slotCovers = {"slotCovers", count};
    slotSolids = {"slotSolids", count};
    slotSolidImpulses = {"slotSolidImpulses", count};
}

void FluidStage::reserve(gpu::StepParameters& parameters, const gpu::Counters& counters) const
{
    if (counters.wantedNeighbours <= parameters.fluidSlots) return;
    parameters.fluidSlots = (counters.wantedNeighbours + 11) / 4 * 4;
}

void FluidStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, fluidMaterials);
    table.add(Lifetime::State, fluidCellCounts, fluidCellSums, fluidPasts);  // they begin a search with zeros
    table.add(Lifetime::Scratch, fluidSearchPositions, fluidParticleCells, fluidCellStarts, fluidCellMembers,
              fluidNearSolids, slotParticles, particleSlots, slotCounts, slotNeighbours, slotColliders, slotMaterials,
              slotVelocities, slotGradients, slotPositions, slotMoves, slotShapes, slotPressures, slotVorticities,
              slotWalls, slotCovers, slotSolids, slotSolidImpulses, particleWets, bodySeals, fluidLargestPush,
              freeSlots, walledSlots, coveredSlots, slotListSizes);
    ElementType fourAtATime = elementType<uint32_t>();
    fourAtATime.texelBytes = 16;
    table.add("fluidSorted", fluidSorted, fourAtATime, Lifetime::Scratch);
}

Defines FluidStage::ofSolids(Defines others) const
{
    if (hasSolids_) others.push_back({"SOLIDS", "1"});
    return others;
}

Defines FluidStage::densityOf(const char* list) const
{
    Defines defines = {{list, "1"}};
    if (hasPool_) defines.push_back({"EMITTERS", "1"});
    return defines;
}

Defines FluidStage::pressureOf(const char* list) const
{
    Defines defines = {{list, "1"}};
    if (hasTension_) defines.push_back({"TENSION", "1"});
    return defines;
}

void FluidStage::perList(Recorder& recorder, const Kernel& free, const Kernel& walled, const Kernel& covered) const
{
    recorder.decided(free, slotListSizes, FREE_SLOTS_SIZE);
    if (hasColliders_) recorder.decided(walled, slotListSizes, WALLED_SLOTS_SIZE);
    if (hasSolids_) recorder.decided(covered, slotListSizes, COVERED_SLOTS_SIZE);
}

void FluidStage::list(Recorder& recorder) const
{
    const uint32_t particles = parameters_.particleCount + parameters_.fluidCount;
    const uint32_t cells = parameters_.fluidCellMask + 1;
    recorder.perElement(searchPosition_, particles);
    if (hasSolids_) recorder.perElement(nearSolids_, parameters_.particleCount);
    recorder.perElement(count_, particles);
    recorder.perElement(sum_, cells / SCAN_CHUNK);
    recorder.perElement(start_, cells / SCAN_CHUNK);
    recorder.perElement(scatter_, particles);
    recorder.perElement(order_, particles);
    perSlot(recorder, find_);
    perSlot(recorder, colliderNear_);
    perSlot(recorder, slotLists_);
}

void FluidStage::beginStep(Recorder& recorder) const
{
    list(recorder);
    perSlot(recorder, gather_);
    recorder.perElement(predict_, parameters_.fluidCount);
    perSlot(recorder, gradient_);
    perSlot(recorder, viscosity_);
    if (!confines_) return;
    perSlot(recorder, vorticity_);
    perSlot(recorder, confinement_);
}

void FluidStage::listInPlace(Recorder& recorder) const
{
    list(recorder);
    recorder.perElement(predictRelaxed_, parameters_.fluidCount);
    recorder.perElement(predictSolidRelaxed_, parameters_.particleCount);
    perSlot(recorder, shape_);
}

void FluidStage::relax(Recorder& recorder)
{
    makeRoom(recorder);
    if (settles_) settle(recorder);
}

void FluidStage::makeRoom(Recorder& recorder)
{
    const float atRest = STARTS_WITH * parameters_.substepTime;
    float largest = 2.0f * atRest;
    for (int look = 0; look < MOST_LOOKS && largest > atRest; ++look) {
        listInPlace(recorder);
        for (int k = 0; k < RELAXATIONS; ++k) {
            if (k + 1 == RELAXATIONS) fluidLargestPush.clear();
            perSlot(recorder, densityRelaxed_);
            perSlot(recorder, pressureRelaxed_);
        }
        largest = std::bit_cast<float>(fluidLargestPush.download()[0]);
    }
}

void FluidStage::settle(Recorder& recorder)
{
    const float weight = vectorOf(parameters_.gravity).norm() * parameters_.substepTime * parameters_.substepTime;
    float largest = 2.0f * SETTLED * weight;
    for (int look = 0; look < MOST_SETTLING && largest > SETTLED * weight; ++look) {
        if (look >= LEAST_SETTLING && largest > FALLING * weight) return;
        listInPlace(recorder);
        slotMoves.clear();
        for (int k = 0; k < RELAXATIONS; ++k) {
            // Of several passes: what swings stops now and then.
            if (k == RELAXATIONS / 2) fluidLargestPush.clear();
            perSlot(recorder, densitySettled_);
            perSlot(recorder, pressureSettled_);
        }
        largest = std::bit_cast<float>(fluidLargestPush.download()[0]);
    }
}

void FluidStage::substep(Recorder& recorder, uint32_t index) const
{
    if (index == 0) recorder.perElement(predict_, parameters_.fluidCount);
    recorder.perElement(predictSolid_, parameters_.particleCount);
    if (index % SHAPE_SUBSTEPS == 0) perSlot(recorder, shape_);
    perList(recorder, densityFree_, densityWalled_, densityCovered_);
    perList(recorder, pressureFree_, pressureWalled_, pressureCovered_);
    recorder.perElement(coupling_, parameters_.particleCount);
    if (!seals_) return;
    recorder.perElement(bodySeal_, parameters_.bodyCount);
    recorder.perElement(seal_, parameters_.particleCount);
}

std::vector<std::pair<uint32_t, float>> FluidStage::densities() const
{
    const std::vector<gpu::vec4> covers = slotCovers.download();
    const std::vector<uint32_t> particles = slotParticles.download();
    std::vector<std::pair<uint32_t, float>> densities;
    // Inactive particles have no slot.
    uint32_t slots = 0;
    fluidCellStarts.read(&slots, sizeof slots, (parameters_.fluidCellMask + 1) * sizeof slots);
    for (size_t k = 0; k < slots; ++k)
        if (particles[k] >= parameters_.particleCount) densities.emplace_back(particles[k], covers[k].w);
    return densities;
}

void FluidStage::show(ParticleView& view) const
{
    view.particleSlots = particleSlots.id();
    view.slotParticles = slotParticles.id();
    view.slotPressures = slotPressures.id();
    view.slotShapes = slotShapes.id();
    view.slotCovers = slotCovers.id();
    // A multiplier acts as the impulse (lambda_i + lambda_j) grad W, a pressure as the force -V (p_i + p_j) grad W.
    const float volume = std::pow(parameters_.fluidSpacing, 3.0f), h = parameters_.substepTime;
    view.pressureUnit = lambdaUnit(parameters_) / (volume * h * h);
}

}  // namespace knuckle
