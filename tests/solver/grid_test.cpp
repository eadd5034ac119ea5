#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver_test.h"

namespace knuckle::test {

namespace {

/// Particles all over 9^3 cells on both sides of the origin, which puts some into the two cells listed twice.
class Grid : public testing::TestWithParam<GridKind> {
protected:
    Grid() : bench(mixedWorld())
    {
        const uint32_t count = bench.buffers.parameters.particleCount;
        positions = randomVectors(count, 0.5f, 3);
        predicted = randomVectors(count, 0.003f, 4);
        positions[count - 1] = packed({0.01f, 0.02f, 0.03f});
        positions[2] = packed({0.02f, 0.01f, 0.03f});
        positions[40] = packed({0.13f, 0.01f, 0.03f});
        fill(bench.buffers.positions, positions);
        fill(bench.buffers.predicted, predicted);
        // Left behind by an earlier search.
        fill(bench.buffers.cellCounts, std::vector<uint32_t>(bench.buffers.cellCounts.size(), 77));
        bench.fillGrid(gridDefines(GetParam()));
    }
    /// Where a particle is when it is sorted.
    Vector3f place(uint32_t i) const { return vec3(positions[i]) + vec3(predicted[i]); }
    /// The wrapped lattice, or the hash of physics.md's source (Teschner et al. 2003).
    uint32_t cellOf(uint32_t i) const
    {
        const gpu::StepParameters& p = bench.buffers.parameters;
        const Eigen::Vector3i c = (place(i) * p.inverseCellSize).array().floor().cast<int>();
        const auto x = static_cast<uint32_t>(c.x()), y = static_cast<uint32_t>(c.y()), z = static_cast<uint32_t>(c.z());
        if (GetParam() == GridKind::Hash) return (73856093u * x ^ 19349663u * y ^ 83492791u * z) & p.cellMask;
        return (x + p.cellStrideY * y + p.cellStrideZ * z) & p.cellMask;
    }
    /// Particles by cell, each cell by id.
    std::vector<uint32_t> sorted() const
    {
        std::vector<uint32_t> ids(positions.size());
        std::iota(ids.begin(), ids.end(), 0u);
        std::stable_sort(ids.begin(), ids.end(), [&](uint32_t a, uint32_t b) { return cellOf(a) < cellOf(b); });
        return ids;
    }
    std::vector<uint32_t> histogram() const
    {
        std::vector<uint32_t> counts(bench.buffers.cellCounts.size(), 0);
        for (uint32_t i = 0; i < positions.size(); ++i) ++counts[cellOf(i)];
        return counts;
    }

    Bench bench;
    std::vector<gpu::vec4> positions, predicted;
};

TEST_P(Grid, CountsTheParticlesOfEachCell)
{
    EXPECT_EQ(bench.buffers.cellCounts.download(), histogram());
    const auto cells = bench.buffers.particleCells.download();
    for (uint32_t i = 0; i < cells.size(); ++i) ASSERT_EQ(cells[i].x, cellOf(i)) << "particle " << i;
}

TEST_P(Grid, NotesWhereEachParticleStood)
{
    const auto found = bench.buffers.foundPositions.download();
    for (uint32_t i = 0; i < found.size(); ++i) ASSERT_EQ(vec3(found[i]), place(i)) << "particle " << i;
}

TEST_P(Grid, CellsStartAtThePrefixSumOfTheCounts)
{
    const auto counts = histogram();
    ASSERT_GT(counts[0], 0u);
    ASSERT_GT(counts[1] + uint32_t(GetParam() == GridKind::Hash), 0u);
    std::vector<uint32_t> starts(counts.size());
    std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0u);
    // The first two cells stand once more behind the last.
    const auto all = static_cast<uint32_t>(positions.size());
    for (uint32_t more : {all, all + counts[0], all + counts[0] + counts[1]}) starts.push_back(more);
    EXPECT_EQ(bench.buffers.cellStarts.download(), starts);
}

TEST_P(Grid, SortsParticlesByCellAndIdAndListsTheFirstTwoCellsAgain)
{
    auto expected = sorted();
    const auto counts = histogram();
    for (uint32_t k = 0; k < counts[0] + counts[1]; ++k) expected.push_back(expected[k]);
    const auto ids = bench.buffers.sortedIds.download();
    const auto places = bench.buffers.sortedPositions.download();
    ASSERT_LE(expected.size(), ids.size());
    for (uint32_t k = 0; k < expected.size(); ++k) {
        ASSERT_EQ(ids[k], expected[k]) << "place " << k;
        ASSERT_EQ(vec3(places[k]), place(expected[k])) << "place " << k;
    }
}

TEST_P(Grid, SortsTheSameWhenParticlesArriveInAnotherOrder)
{
    // Scatter once more with the arrivals of each cell reversed, as another thread order could have left them.
    const auto before = bench.buffers.sortedIds.download();
    auto cells = bench.buffers.particleCells.download();
    const auto counts = bench.buffers.cellCounts.download();
    for (gpu::uvec2& c : cells) c.y = counts[c.x] - 1 - c.y;
    fill(bench.buffers.particleCells, cells);
    bench.buffers.sortedIds.clear();
    bench.forParticles("grid_scatter");
    bench.forParticles("grid_order");
    EXPECT_EQ(bench.buffers.sortedIds.download(), before);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Grid, testing::Values(GridKind::Lattice, GridKind::Hash), gridName);

}  // namespace

}  // namespace knuckle::test
