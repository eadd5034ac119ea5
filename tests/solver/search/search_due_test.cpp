#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr uint32_t SUBSTEP = 12;

/// Work groups per dispatch of a search.
struct SearchSize {
    uint32_t dispatch;
    uint64_t threads;
};

class SearchDue : public testing::Test {
protected:
    SearchDue() : fixture(mixedWorld())
    {
        // More than in the world, so that lists of all lengths take several groups.
        fixture.stages.parameters.particleCount = 30001;
        fixture.stages.parameters.moverCount = 20011;
        fixture.setParameters();
        counters.substep = SUBSTEP;
        counters.listParity = 1;
        counters.searchCount = 7;
        counters.fastCount = 3;
        counters.fastLater = fixture.stages.parameters.fastLimit + 1;
        counters.farSighted = 1;
        counters.fastListed = 2;
        counters.candidateCount = 3;
        counters.pairCount = 55;
        // Leftovers of the last search.
        fill(fixture.stages.dispatches, std::vector<gpu::uvec4>(DISPATCH_COUNT, gpu::uvec4{9, 1, 1, 0}));
    }
    void run()
    {
        fixture.setCounters(counters);
        fixture.run("search/search_due", 1);
        counters = fixture.counters();
        sizes = fixture.stages.dispatches.download();
    }
    std::vector<SearchSize> searchSizes() const
    {
        const gpu::StepParameters& p = fixture.stages.parameters;
        return {{DISPATCH_PARTICLES, p.particleCount},
                {DISPATCH_CELL_CHUNKS, (p.cellMask + 1) / SCAN_CHUNK},
                {DISPATCH_MOVERS, p.moverCount},
                {DISPATCH_LIST_CHUNKS, (3 * p.particleCount + SCAN_CHUNK - 1) / SCAN_CHUNK}};
    }
    void expectSearch(bool found)
    {
        for (const auto& [dispatch, threads] : searchSizes()) {
            EXPECT_EQ(sizes[dispatch].x, found ? groupsFor(threads) : 0u) << "dispatch " << dispatch;
            EXPECT_EQ(sizes[dispatch].y, 1u);
            EXPECT_EQ(sizes[dispatch].z, 1u);
        }
        // Their sizes are known later.
        for (uint32_t dispatch : {DISPATCH_NEW_PAIRS, DISPATCH_NEW_COLLIDER_PAIRS, DISPATCH_FAST, DISPATCH_CANDIDATES})
            EXPECT_EQ(sizes[dispatch].x, 0u) << "dispatch " << dispatch;
        // The contacts of the last search, which are solved if there is no new one.
        for (uint32_t dispatch : {DISPATCH_PAIRS, DISPATCH_COLLIDER_PAIRS}) EXPECT_EQ(sizes[dispatch].x, 9u);
        EXPECT_EQ(counters.pairCount, 55u);
        EXPECT_EQ(counters.listParity, found ? 0u : 1u);
        EXPECT_EQ(counters.searchCount, found ? 8u : 7u);
        EXPECT_EQ(counters.fastCount, 0u);
        EXPECT_EQ(counters.fastListed, 0u);
        EXPECT_EQ(counters.candidateCount, 0u);
        EXPECT_EQ(counters.fastLater, found ? 0u : fixture.stages.parameters.fastLimit + 1u);
        EXPECT_EQ(counters.farSighted, found ? 0u : 1u) << "too many were fast in the last search";
        EXPECT_EQ(counters.due, 0u);
    }

    KernelFixture fixture;
    gpu::Counters counters{};
    std::vector<gpu::uvec4> sizes;
};

TEST_F(SearchDue, NothingIsSearchedWhereNobodyHasLeftItsMargin)
{
    run();
    expectSearch(false);
    EXPECT_EQ(counters.substep, SUBSTEP + 1);
}

TEST_F(SearchDue, ASearchIsMadeWhereSomebodyHas)
{
    counters.due = 1;
    run();
    expectSearch(true);
    EXPECT_EQ(counters.substep, SUBSTEP + 1);
}

TEST_F(SearchDue, TheFirstSubstepSearches)
{
    counters.substep = 0;
    run();
    expectSearch(true);
    EXPECT_EQ(counters.substep, 1u);
}

}  // namespace

}  // namespace knuckle::test
