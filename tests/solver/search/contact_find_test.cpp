#include <algorithm>
#include <map>

#include "tests/solver/search/search_test.h"

namespace knuckle::test {

namespace {

class ContactFind : public testing::TestWithParam<GridKind> {
protected:
    using Pair = std::pair<uint32_t, uint32_t>;

    void find()
    {
        fixture.findPairs(GetParam());
        noted = fixture.notedPairs();
    }
    /// How often each pair was found, lower id first.
    std::map<Pair, int> timesFound() const
    {
        std::map<Pair, int> times;
        for (uint32_t i = 0; i < noted.size(); ++i)
            for (uint32_t j : noted[i]) ++times[std::minmax(i, j)];
        return times;
    }
    /// Compares the found pairs with all pairs of particles. @returns those that had to be found.
    std::vector<Pair> expectAllPairsOnce()
    {
        auto times = timesFound();
        std::vector<Pair> wanted;
        for (uint32_t i = 0; i < fixture.count(); ++i)
            for (uint32_t j = i + 1; j < fixture.count(); ++j) {
                const float inside = fixture.limitOf(i, j) - fixture.distance(i, j);
                const auto at = times.find({i, j});
                const int found = at == times.end() ? 0 : at->second;
                const bool may = inside > -DISTANCE_ROUNDING && fixture.mayTouch(i, j);
                if (may && inside > DISTANCE_ROUNDING) {
                    EXPECT_EQ(found, 1) << "particles " << i << " and " << j;
                    wanted.push_back({i, j});
                } else {
                    EXPECT_LE(found, may ? 1 : 0) << "particles " << i << " and " << j;
                }
            }
        return wanted;
    }

    SearchBench fixture;
    std::vector<std::vector<uint32_t>> noted;
};

TEST_P(ContactFind, FindsEachPairInReachOnce)
{
    find();
    EXPECT_GT(expectAllPairsOnce().size(), 2000u) << "the world is too thin to test anything";
    uint32_t excluded = 0;
    for (uint32_t i = 0; i < fixture.count(); ++i)
        for (uint32_t j = 0; j < i; ++j) excluded += fixture.distance(i, j) < DIAMETER && !fixture.mayTouch(i, j);
    EXPECT_GT(excluded, 20u);
    EXPECT_EQ(fixture.counters().problems, 0u);
}

TEST_P(ContactFind, FastMoversFindAllInTheirReachOnce)
{
    fixture.makeSomeFast();
    find();
    uint32_t withSlow = 0, withFast = 0;
    for (const auto& [i, j] : expectAllPairsOnce()) {
        if (fixture.distance(i, j) < fixture.stages.parameters.contactReach) continue;
        (fixture.isFast(i) && fixture.isFast(j) ? withFast : withSlow) += 1;
    }
    EXPECT_GT(withSlow, 300u) << "that only their reach finds";
    EXPECT_GT(withFast, 50u) << "that only the reach of both finds";
    EXPECT_EQ(fixture.counters().problems, 0u);
}

TEST_P(ContactFind, FastMoversLookIntoEveryCellUpToTwoAway)
{
    // Two loose particles in cells this far apart, each near the other's cell, for each such pair of cells.
    const gpu::StepParameters& p = fixture.stages.parameters;
    auto positions = fixture.found;
    std::vector<float> reaches(p.moverCount, 0.0f);
    uint32_t loose = fixture.count() - 1;
    for (int k = 0; k < 125; ++k) {
        const Eigen::Vector3i cells(k % 5 - 2, k / 5 % 5 - 2, k / 25 - 2);
        Vector3f near = Vector3f::Constant(6.5f) + 6.0f * Eigen::Vector3i(k % 5, k / 5 % 5, k / 25).cast<float>();
        Vector3f far = near;
        for (int axis = 0; axis < 3; ++axis) {
            const int apart = cells[axis];
            const float side = apart < 0 ? -1.0f : 1.0f;
            if (apart == 0) continue;
            near[axis] += 0.49f * side;
            far[axis] += 0.51f * side + static_cast<float>(apart) - side;
        }
        for (const Vector3f& place : {near, far}) {
            ASSERT_EQ(fixture.world.particles[loose].body, NO_INDEX);
            reaches[fixture.moverOf(loose)] = p.farReach;
            positions[loose--] = packed(place / p.inverseCellSize);
        }
    }
    fixture.setReaches(reaches);
    fixture.place(positions);
    find();
    uint32_t found = 0;
    for (const auto& [i, j] : expectAllPairsOnce()) found += fixture.isFast(i) && fixture.isFast(j);
    EXPECT_GE(found, 125u);
}

TEST_P(ContactFind, TheFirstOfAPairIsTheFastOneOrOfTwoTheOneOfLowerRank)
{
    fixture.makeSomeFast();
    find();
    for (uint32_t i = 0; i < fixture.count(); ++i)
        for (uint32_t j : noted[i]) {
            if (!fixture.isFast(j)) continue;
            ASSERT_TRUE(fixture.isFast(i)) << "particles " << i << " and " << j;
            ASSERT_LT(fixture.rankOf(i), fixture.rankOf(j));
        }
}

TEST_P(ContactFind, SecondParticlesCountTheirPairsAndNumberThem)
{
    fixture.makeSomeFast();
    find();
    const auto counts = fixture.stages.search.listCounts.download();
    std::vector<std::vector<uint32_t>> arrivals(fixture.count());
    for (const gpu::uvec4& candidate : fixture.candidates()) arrivals[candidate.y].push_back(candidate.w);
    for (uint32_t j = 0; j < fixture.count(); ++j) {
        std::sort(arrivals[j].begin(), arrivals[j].end());
        ASSERT_EQ(counts[fixture.count() + fixture.rankOf(j)], arrivals[j].size()) << "particle " << j;
        for (uint32_t k = 0; k < arrivals[j].size(); ++k) ASSERT_EQ(arrivals[j][k], k) << "particle " << j;
    }
}

TEST_P(ContactFind, TheRulesOfWhatTouchesAllMatterHere)
{
    // Pairs near each other, not of one first body, but excluded by each rule alone: otherwise the tests above would
    // prove less than they claim.
    uint32_t crosses = 0, overlaps = 0, margins = 0, shared = 0, neighbours = 0;
    const auto& particles = fixture.world.particles;
    for (uint32_t i = 0; i < fixture.count(); ++i)
        for (uint32_t j = 0; j < i; ++j) {
            const Particle& a = particles[i];
            const Particle& b = particles[j];
            if (a.assembly != b.assembly || a.assembly == NO_INDEX || a.body == b.body) continue;
            if (fixture.distance(i, j) > DIAMETER) continue;
            const bool overlap = restDistance(a, b) <= leastRestDistance(a, b);
            const bool cross = !a.touchesAssembly || !b.touchesAssembly;
            crosses += cross && !overlap;
            overlaps += overlap && !cross && restDistance(a, b) <= 0.99f * DIAMETER;
            margins += overlap && !cross && restDistance(a, b) > DIAMETER;
            const bool neighbour = areFiltered(fixture.world, a.body, b.body);
            neighbours += neighbour && !overlap && !cross;
            shared += !neighbour && !overlap && !cross && !fixture.mayTouch(i, j);
        }
    EXPECT_GT(crosses, 0u);
    EXPECT_GT(overlaps, 0u);
    EXPECT_GT(neighbours, 0u);
    EXPECT_GT(margins, 0u);
    EXPECT_GT(shared, 0u) << "a shared particle and one of its second body";
}

TEST_P(ContactFind, CandidatesThatThereIsNoRoomForAreCountedAndLeftOut)
{
    fixture.makeSomeFast();
    find();
    const auto all = timesFound();
    constexpr uint32_t ROOM = 1003;
    fixture.narrow(ROOM, fixture.stages.parameters.pairCapacity, fixture.stages.parameters.colliderPairCapacity);
    const gpu::uvec4 untouched{0xabcdu, 0xef01u, 0x2345u, 0x6789u};
    fill(fixture.stages.search.candidates, std::vector<gpu::uvec4>(fixture.stages.search.candidates.size(), untouched));
    fixture.place(fixture.found);
    fixture.findPairs(GetParam());
    ASSERT_GT(all.size(), ROOM);
    EXPECT_EQ(fixture.counters().candidateCount, all.size());
    for (const gpu::uvec4& candidate : fixture.candidates())
        ASSERT_TRUE(all.contains(std::minmax(candidate.x, candidate.y)));
    const auto entries = fixture.stages.search.candidates.download();
    for (size_t k = ROOM; k < entries.size(); ++k) ASSERT_EQ(entries[k].x, untouched.x) << "candidate " << k;
}

TEST_P(ContactFind, TheFastOnesGetAThreadEach)
{
    find();
    EXPECT_EQ(fixture.stages.dispatches.download()[DISPATCH_FAST].x, 0u);
    fixture.makeSomeFast();
    for (uint32_t fast : {1u, uint32_t(GROUP_SIZE), GROUP_SIZE + 1u}) {
        gpu::Counters counters = fixture.counters();
        counters.fastListed = fast;
        fixture.setCounters(counters);
        fixture.place(fixture.found);
        find();
        EXPECT_EQ(fixture.stages.dispatches.download()[DISPATCH_FAST].x, groupsFor(fast));
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ContactFind, testing::Values(GridKind::Lattice, GridKind::Hash), gridName);

}  // namespace

}  // namespace knuckle::test
