#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr uint32_t SUBSTEP = 12;

/// Work groups per dispatch of a search.
struct SearchSize {
    uint32_t dispatch;
    uint64_t threads;
};

class FindDue : public testing::Test {
protected:
    FindDue() : bench(mixedWorld())
    {
        // More than the world has, so that lists of all lengths take several groups.
        bench.buffers.parameters.particleCount = 30001;
        bench.buffers.parameters.moverCount = 20011;
        bench.setParameters();
        counters.substep = SUBSTEP;
        counters.listParity = 1;
        counters.findCount = 7;
        counters.fastCount = 3;
        counters.fastLater = bench.buffers.parameters.fastLimit + 1;
        counters.calm = 1;
        counters.fastListed = 2;
        counters.pairCount = 55;
        // What the last search left.
        fill(bench.buffers.dispatches, std::vector<gpu::uvec4>(DISPATCH_COUNT, gpu::uvec4{9, 1, 1, 0}));
    }
    void run()
    {
        bench.setCounters(counters);
        bench.run("search/find_due", 1);
        counters = bench.counters();
        sizes = bench.buffers.dispatches.download();
    }
    std::vector<SearchSize> searchSizes() const
    {
        const gpu::StepParameters& p = bench.buffers.parameters;
        return {{DISPATCH_PARTICLES, p.particleCount}, {DISPATCH_CELLS, p.cellMask + 1},
                {DISPATCH_CELL_CHUNKS, (p.cellMask + 1) / SCAN_CHUNK}, {DISPATCH_MOVERS, p.moverCount},
                {DISPATCH_ONE, 1}, {DISPATCH_LIST_CHUNKS, (3 * p.particleCount + SCAN_CHUNK - 1) / SCAN_CHUNK}};
    }
    void expectSearch(bool found)
    {
        for (const auto& [dispatch, threads] : searchSizes()) {
            EXPECT_EQ(sizes[dispatch].x, found ? groupsFor(threads) : 0u) << "dispatch " << dispatch;
            EXPECT_EQ(sizes[dispatch].y, 1u);
            EXPECT_EQ(sizes[dispatch].z, 1u);
        }
        // Their sizes are known later.
        for (uint32_t dispatch : {DISPATCH_NEW_PAIRS, DISPATCH_NEW_COLLIDER_PAIRS, DISPATCH_FAST})
            EXPECT_EQ(sizes[dispatch].x, 0u) << "dispatch " << dispatch;
        // The contacts of the last search, which are solved where there is no new one.
        for (uint32_t dispatch : {DISPATCH_PAIRS, DISPATCH_COLLIDER_PAIRS}) EXPECT_EQ(sizes[dispatch].x, 9u);
        EXPECT_EQ(counters.pairCount, 55u);
        EXPECT_EQ(counters.listParity, found ? 0u : 1u);
        EXPECT_EQ(counters.findCount, found ? 8u : 7u);
        EXPECT_EQ(counters.fastCount, 0u);
        EXPECT_EQ(counters.fastListed, 0u);
        EXPECT_EQ(counters.fastLater, found ? 0u : bench.buffers.parameters.fastLimit + 1u);
        EXPECT_EQ(counters.calm, found ? 0u : 1u) << "too many were fast in the last search";
        EXPECT_EQ(counters.due, 0u);
    }

    Bench bench;
    gpu::Counters counters{};
    std::vector<gpu::uvec4> sizes;
};

TEST_F(FindDue, NothingIsSearchedWhereNobodyHasLeftItsMargin)
{
    run();
    expectSearch(false);
    EXPECT_EQ(counters.substep, SUBSTEP + 1);
}

TEST_F(FindDue, ASearchIsMadeWhereSomebodyHas)
{
    counters.due = 1;
    run();
    expectSearch(true);
    EXPECT_EQ(counters.substep, SUBSTEP + 1);
}

TEST_F(FindDue, TheFirstSubstepSearches)
{
    counters.substep = 0;
    run();
    expectSearch(true);
    EXPECT_EQ(counters.substep, 1u);
}

TEST_F(FindDue, TheFastOnesGetAThreadEach)
{
    for (uint32_t fast : {0u, 1u, uint32_t(GROUP_SIZE), GROUP_SIZE + 1u}) {
        counters.fastListed = fast;
        bench.setCounters(counters);
        bench.run("search/fast_due", 1);
        EXPECT_EQ(bench.buffers.dispatches.download()[DISPATCH_FAST].x, groupsFor(fast));
    }
}

}  // namespace

}  // namespace knuckle::test
