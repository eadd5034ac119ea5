#include "sim/solver/search/search_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "sim/base/errors.h"
#include "sim/solver/scan.h"
#include "sim/world/matter/grain.h"

namespace knuckle {

namespace {

constexpr uint32_t MOST_MOVERS = 1u << 23;  // contacts have 23 bits for one
// Largest distance of two particles of which one touches the other's box [diameters]: root 1.5 in the middle of four of
// a face, less the depth that it may sink in before it is found; root 2 would find all neighbours across two faces.
constexpr float FLAT_TOUCH = 1.2f;
// The same for a ball or capsule: between its particles, its surface is up to a diameter further out than they are.
constexpr float ROUND_TOUCH = 1.7f;

}  // namespace

SearchStage::SearchStage(const StageSetup& setup)
    : parameters_(setup.parameters), byParticles_(setup.world.settings.solver == SolverKind::Paper),
      hasSolids_(setup.layout.solidCount > 0), hasColliders_(hasSolids_ && !setup.world.colliders.empty())
{
}

void SearchStage::upload(const StageSetup& setup)
{
    setParameters(setup);
    makeGrid(setup.parameters);
    uploadFilters(setup.world);
    const uint32_t movers = setup.layout.moverCount();
    const std::vector<gpu::vec4> unturned(movers, gpu::vec4{0, 0, 0, 1});
    // All colliders, for a solver that does not look which are near.
    const uint32_t colliders = setup.layout.colliderCount;
    const std::vector<uint32_t> all(movers, colliders < 32 ? (1u << colliders) - 1u : ~0u);
    searchPositions = {"searchPositions", setup.world.particles.size()};
    searchCentres = {"searchCentres", movers};
    searchRotations = {"searchRotations", std::span<const gpu::vec4>(unturned)};
    moverReaches = {"moverReaches", movers};
    moverColliders = {"moverColliders", std::span<const uint32_t>(all)};
}

void SearchStage::uploadFilters(const World& world)
{
    std::vector<gpu::uvec4> ranges;
    std::vector<uint32_t> words;
    for (const Body& body : world.bodies) {
        const auto firstWord = static_cast<uint32_t>(words.size());
        if (body.filtered.empty()) {
            ranges.push_back({0, 0, 0, 0});
            continue;
        }
        const Object& object = world.objects[body.object];
        ranges.push_back({32 * firstWord, object.bodyStart, object.bodyEnd(), 0});
        words.resize(firstWord + (object.bodyCount + 31) / 32);
        for (const uint32_t other : body.filtered) {
            const uint32_t bit = other - object.bodyStart;
            words[firstWord + bit / 32] |= 1u << bit % 32;
        }
    }
    bodyFilters = {"bodyFilters", std::span<const gpu::uvec4>(ranges)};
    filterBits = {"filterBits", std::span<const uint32_t>(words)};
}

/// Sets how far the search looks for contacts, and how long they stay valid. Neighbours rarely both use up their
/// margins against each other, so each may drift by more than half of it. The paper's particles may drift by a quarter:
/// the iterations move them further by as much.
void SearchStage::setParameters(const StageSetup& setup)
{
    const Settings& s = setup.world.settings;
    gpu::StepParameters& p = setup.parameters;
    p.plainReach = ((setup.layout.hasFlatFaces ? FLAT_TOUCH : 1.0f) + s.contactMargin) * p.diameter;
    p.contactReach = setup.layout.hasRounds ? (ROUND_TOUCH + s.contactMargin) * p.diameter : p.plainReach;
    if (const float excess = largestScale(setup.world) - 1.0f; excess > 0.0f)
        p.contactReach = std::max(p.contactReach / p.diameter + 0.5f * excess, 1.0f + s.contactMargin + excess) *
                         p.diameter;
    p.inverseCellSize = 1.0f / p.contactReach;
    p.drift = (byParticles_ ? 0.25f : 1.0f) * s.contactMargin * p.diameter;
    p.lookAhead = 0.5f * static_cast<float>(s.substeps);
    p.horizon = 2.0f * static_cast<float>(s.substeps);
    p.farReach = 0.5f * p.contactReach;
    p.fastLimit = p.particleCount / 8;
    p.pairCapacity = p.colliderPairCapacity = std::max(2 * p.particleCount, 4096u);
    p.candidateCapacity = 2 * p.pairCapacity;
}

void SearchStage::makeGrid(gpu::StepParameters& p)
{
    const uint32_t count = p.particleCount, cells = std::bit_ceil(std::max(2 * count, 4096u));
    // A box of cells about as wide as high and deep, wrapped.
    const uint32_t bits = static_cast<uint32_t>(std::countr_zero(cells));
    p.cellMask = cells - 1;
    p.cellStrideY = 1u << (bits / 3);
    p.cellStrideZ = 1u << (2 * bits / 3);
    cellCounts = {"cellCounts", cells};
    cellCounts.clear();
    cellSums = scanSums("cellSums", cells);
    cellStarts = {"cellStarts", cells + WRAPPED_CELLS + 1};
    cellMembers = {"cellMembers", count};
    fastParticles = {"fastParticles", count};
    particleCells = {"particleCells", count};
    sortedPositions = {"sortedPositions", 2 * size_t(count)};
    sortedParticles = {"sortedParticles", 2 * size_t(count)};
}

void SearchStage::makeLists()
{
    const gpu::StepParameters& p = parameters_;
    const size_t count = p.particleCount;
    if (p.moverCount > MOST_MOVERS)
        throw DeviceError(fmt::format("{} bodies and loose particles, where contacts have numbers for {}; use fewer",
                                      p.moverCount, MOST_MOVERS));
    candidates = {"candidates", p.candidateCapacity};
    if (listSums.id() == 0 || listCounts.size() != 3 * count) listSums = scanSums("listSums", 3 * count);
    listCounts.resize("listCounts", 3 * count);
    listStarts.resize("listStarts", 2 * (3 * count + 1), HALVES);
    pairs.resize("pairs", 2 * size_t(p.pairCapacity), HALVES);
    pairArrivals = {"pairArrivals", p.candidateCapacity};
    pairReferences.resize("pairReferences", p.candidateCapacity);
    colliderPairs.resize("colliderPairs", 2 * size_t(p.colliderPairCapacity), HALVES);
}

void SearchStage::reserve(gpu::StepParameters& p, const gpu::Counters& counters) const
{
    if (counters.wantedCandidates > p.candidateCapacity) p.candidateCapacity = counters.wantedCandidates * 3 / 2;
    if (counters.wantedPairs > p.pairCapacity) p.pairCapacity = counters.wantedPairs * 3 / 2;
    if (counters.wantedColliderPairs > p.colliderPairCapacity)
        p.colliderPairCapacity = counters.wantedColliderPairs * 3 / 2;
}

void SearchStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, bodyFilters);
    table.add(Lifetime::State, filterBits, searchPositions, searchCentres, searchRotations, listStarts, pairs,
              pairReferences, colliderPairs);
    table.add(Lifetime::State, cellCounts, cellSums, listCounts, listSums);  // zero at the start of a search
    table.add(Lifetime::Scratch, moverReaches, fastParticles, moverColliders, particleCells, cellStarts, cellMembers,
              sortedPositions, sortedParticles, candidates, pairArrivals);
}

void SearchStage::count(Recorder& recorder) const
{
    recorder.groups(due_, 1);
}

void SearchStage::find(Recorder& recorder) const
{
    if (!byParticles_) recorder.perElement(drift_, parameters_.moverCount);
    count(recorder);
    if (!byParticles_) recorder.decided(reach_, DISPATCH_MOVERS);
    recorder.decided(centre_, DISPATCH_MOVERS);
    recorder.decided(position_, DISPATCH_PARTICLES);
    recorder.decided(countCells_, DISPATCH_PARTICLES);
    recorder.decided(cellSum_, DISPATCH_CELL_CHUNKS);
    recorder.decided(cellStart_, DISPATCH_CELL_CHUNKS);
    recorder.decided(scatter_, DISPATCH_PARTICLES);
    recorder.decided(order_, DISPATCH_PARTICLES);
    recorder.decided(find_, DISPATCH_PARTICLES);
    recorder.decided(findFar_, DISPATCH_FAST);
    if (hasColliders_) {
        if (!byParticles_) recorder.decided(colliderNear_, DISPATCH_MOVERS);
        recorder.decided(colliderFind_, DISPATCH_PARTICLES);
    }
    recorder.decided(listSum_, DISPATCH_LIST_CHUNKS);
    recorder.decided(listStart_, DISPATCH_LIST_CHUNKS);
    recorder.decided(list_, DISPATCH_CANDIDATES);
}

}  // namespace knuckle
