#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// Particles all over 9^3 cells on both sides of the origin, some of them in the cells that are listed twice.
class Grid : public testing::TestWithParam<GridKind> {
protected:
    Grid() : fixture(mixedWorld())
    {
        const uint32_t count = fixture.stages.parameters.particleCount;
        places = randomVectors(count, 0.5f, 3);
        places[count - 1] = packed({0.01f, 0.02f, 0.03f});
        places[2] = packed({0.02f, 0.01f, 0.03f});
        for (uint32_t cell = 1; cell < WRAPPED_CELLS; ++cell)
            places[40 * cell] = packed(
                {(static_cast<float>(cell) + 0.1f) / fixture.stages.parameters.inverseCellSize, 0.01f, 0.03f});
        fixture.setFound(places);
        // Every third mover drifts further than the others.
        const float drift = fixture.stages.parameters.drift;
        std::vector<gpu::vec4> centres(fixture.stages.parameters.moverCount, packed({0, 0, 0}, drift));
        for (size_t m = 0; m < centres.size(); m += 3) centres[m].w = std::nextafter(drift, 1.0f);
        fill(fixture.stages.search.searchCentres, centres);
        fixture.fillGrid(gridDefines(GetParam()));
    }
    Vector3f place(uint32_t i) const { return vec3(places[i]); }
    /// The wrapped lattice, or the hash of physics.md's source (Teschner et al. 2003).
    uint32_t cellOf(uint32_t i) const
    {
        const gpu::StepParameters& p = fixture.stages.parameters;
        const Eigen::Vector3i c = (place(i) * p.inverseCellSize).array().floor().cast<int>();
        const auto x = static_cast<uint32_t>(c.x()), y = static_cast<uint32_t>(c.y()), z = static_cast<uint32_t>(c.z());
        if (GetParam() == GridKind::Hash) return (73856093u * x ^ 19349663u * y ^ 83492791u * z) & p.cellMask;
        return (x + p.cellStrideY * y + p.cellStrideZ * z) & p.cellMask;
    }
    /// Particles by cell, each cell by id.
    std::vector<uint32_t> sorted() const
    {
        std::vector<uint32_t> ids(places.size());
        std::iota(ids.begin(), ids.end(), 0u);
        std::stable_sort(ids.begin(), ids.end(), [&](uint32_t a, uint32_t b) { return cellOf(a) < cellOf(b); });
        return ids;
    }
    std::vector<uint32_t> ids() const
    {
        std::vector<uint32_t> found;
        for (uint32_t info : fixture.stages.search.sortedParticles.download()) found.push_back(info >> 1);
        return found;
    }
    std::vector<uint32_t> histogram() const
    {
        std::vector<uint32_t> counts(fixture.stages.search.cellCounts.size(), 0);
        for (uint32_t i = 0; i < places.size(); ++i) ++counts[cellOf(i)];
        return counts;
    }

    KernelFixture fixture;
    std::vector<gpu::vec4> places;
};

TEST_P(Grid, CountsTheParticlesOfEachCell)
{
    const auto& cellCounts = fixture.stages.search.cellCounts;
    EXPECT_EQ(cellCounts.download(), std::vector<uint32_t>(cellCounts.size(), 0)) << "emptied for the next search";
    fixture.forParticles("common/grid/grid_count", gridDefines(GetParam()));
    EXPECT_EQ(cellCounts.download(), histogram());
    const auto cells = fixture.stages.search.particleCells.download();
    for (uint32_t i = 0; i < cells.size(); ++i) ASSERT_EQ(cells[i].x, cellOf(i)) << "particle " << i;
}

TEST_P(Grid, CellsStartAtThePrefixSumOfTheCounts)
{
    const auto counts = histogram();
    std::vector<uint32_t> starts(counts.size());
    std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0u);
    // The first cells are listed again after the last.
    starts.push_back(static_cast<uint32_t>(places.size()));
    for (uint32_t cell = 0; cell < WRAPPED_CELLS; ++cell) {
        if (GetParam() == GridKind::Lattice) {
            ASSERT_GT(counts[cell], 0u);
        }
        starts.push_back(starts.back() + counts[cell]);
    }
    EXPECT_EQ(fixture.stages.search.cellStarts.download(), starts);
}

TEST_P(Grid, SortsParticlesByCellAndIdAndListsTheFirstCellsAgain)
{
    auto expected = sorted();
    const auto counts = histogram();
    const uint32_t again = std::accumulate(counts.begin(), counts.begin() + WRAPPED_CELLS, 0u);
    for (uint32_t k = 0; k < again; ++k) expected.push_back(expected[k]);
    const auto infos = fixture.stages.search.sortedParticles.download();
    const auto sortedPlaces = fixture.stages.search.sortedPositions.download();
    ASSERT_LE(expected.size(), infos.size());
    for (uint32_t k = 0; k < expected.size(); ++k) {
        ASSERT_EQ(infos[k] >> 1, expected[k]) << "place " << k;
        ASSERT_EQ(vec3(sortedPlaces[k]), place(expected[k])) << "place " << k;
    }
}

TEST_P(Grid, TellsOfEachSortedParticleWhatTheSearchNeeds)
{
    const auto infos = fixture.stages.search.sortedParticles.download();
    const auto sortedPlaces = fixture.stages.search.sortedPositions.download();
    const auto ranks = fixture.stages.particles.particleRanks.download();
    const auto states = fixture.stages.bodies.moverStates.download();
    for (uint32_t k = 0; k < places.size(); ++k) {
        const uint32_t mover = ranks[infos[k] >> 1].x;
        ASSERT_EQ(infos[k] & 1u, mover % 3 == 0 ? 1u : 0u) << "place " << k;
        const uint32_t name = states[mover] == MOVER_FIXED ? fixture.stages.parameters.moverCount : mover;
        ASSERT_EQ(std::bit_cast<uint32_t>(sortedPlaces[k].w), 0x01000000u + name) << "place " << k;
    }
}

TEST_P(Grid, SortsTheSameWhenParticlesArriveInAnotherOrder)
{
    // Scatters once more with the arrivals of each cell reversed, as another thread order could have left them.
    const auto before = ids();
    auto cells = fixture.stages.search.particleCells.download();
    const auto counts = histogram();
    for (gpu::uvec2& c : cells) c.y = counts[c.x] - 1 - c.y;
    fill(fixture.stages.search.particleCells, cells);
    fixture.stages.search.sortedParticles.clear();
    fixture.forParticles("common/grid/grid_scatter");
    fixture.forParticles("search/grid_order");
    EXPECT_EQ(ids(), before);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Grid, testing::Values(GridKind::Lattice, GridKind::Hash), gridName);

}  // namespace

}  // namespace knuckle::test
