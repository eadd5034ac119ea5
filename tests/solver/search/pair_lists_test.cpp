#include <algorithm>
#include <numeric>

#include "tests/solver/search/search_test.h"

namespace knuckle::test {

namespace {

class PairLists : public testing::TestWithParam<uint32_t> {
protected:
    PairLists()
    {
        fixture.makeSomeFast();
        if (parity() == 1) fixture.turnHalves();
    }
    uint32_t parity() const { return GetParam(); }
    uint32_t count() const { return fixture.count(); }
    void find()
    {
        fixture.findPairs(GridKind::Lattice);
        noted = fixture.notedPairs();
        fixture.fillLists();
    }
    /// The half of `values` that this search filled.
    template <typename T>
    std::vector<T> current(const std::vector<T>& values) const
    {
        const auto half = static_cast<std::ptrdiff_t>(values.size() / 2);
        return {values.begin() + parity() * half, values.begin() + (parity() + 1) * half};
    }
    /// All pairs by rank of the first particle, those of each particle in the order in which they were noted.
    std::vector<gpu::uvec2> wantedPairs() const
    {
        std::vector<gpu::uvec2> pairs;
        for (uint32_t i : fixture.stages.particles.rankedParticles.download())
            for (uint32_t j : noted[i]) pairs.push_back({i, j});
        return pairs;
    }
    /// The pairs in which each particle is the second, in ascending order, by rank; pairs without room are NO_INDEX, at
    /// the end of each rank.
    std::vector<uint32_t> wantedReferences() const
    {
        const auto pairs = wantedPairs();
        std::vector<uint32_t> references(pairs.size());
        std::iota(references.begin(), references.end(), 0u);
        std::stable_sort(references.begin(), references.end(), [&](uint32_t a, uint32_t b) {
            return fixture.rankOf(pairs[a].y) < fixture.rankOf(pairs[b].y);
        });
        for (uint32_t& q : references)
            if (q >= fixture.stages.parameters.pairCapacity) q = NO_INDEX;  // NO_PAIR of the shaders
        return references;
    }

    SearchBench fixture;
    std::vector<std::vector<uint32_t>> noted;
};

/// Checks that `values` begin with those wanted, and that the rest is unchanged.
void expectBegins(const std::vector<uint32_t>& values, const std::vector<uint32_t>& wanted, uint32_t untouched)
{
    for (size_t k = 0; k < values.size(); ++k)
        ASSERT_EQ(values[k], k < wanted.size() ? wanted[k] : untouched) << "place " << k;
}

/// Checks that the pairs in the first `end` places are those wanted, and that the rest is unchanged.
void expectPairs(const std::vector<gpu::uvec2>& pairs, size_t start, const std::vector<gpu::uvec2>& wanted, size_t end,
                 gpu::uvec2 untouched)
{
    for (size_t q = 0; q < pairs.size(); ++q) {
        const bool filled = q >= start && q < start + end;
        const gpu::uvec2& at = filled ? wanted.at(q - start) : untouched;
        ASSERT_EQ(pairs[q].x, at.x) << "place " << q;
        ASSERT_EQ(pairs[q].y, at.y) << "place " << q;
    }
}

TEST_P(PairLists, ListsStartAtThePrefixSumOfTheirCounts)
{
    Random random(31);
    std::vector<uint32_t> counts(fixture.stages.search.listCounts.size());
    ASSERT_NE(counts.size() % SCAN_CHUNK, 0u) << "the last chunk has to be a short one";
    for (uint32_t& c : counts) c = static_cast<uint32_t>(random.between(0, 9));
    fill(fixture.stages.search.listCounts, counts);
    const std::vector<uint32_t> untouched(fixture.stages.search.listStarts.size(), 12345u);
    fill(fixture.stages.search.listStarts, untouched);
    fixture.fillLists();
    std::vector<uint32_t> wanted(counts.size() + 1);
    std::inclusive_scan(counts.begin(), counts.end(), wanted.begin() + 1);
    const auto starts = fixture.stages.search.listStarts.download();
    EXPECT_EQ(current(starts), wanted);
    const auto other = static_cast<std::ptrdiff_t>((1 - parity()) * wanted.size());
    EXPECT_EQ(std::count(starts.begin() + other, starts.begin() + other + std::ptrdiff_t(wanted.size()), 12345u),
              std::ptrdiff_t(wanted.size()))
        << "the last search's";
}

TEST_P(PairLists, ThePairsOfEachRankStandTogether)
{
    const gpu::uvec2 untouched{77, 78};
    fill(fixture.stages.search.pairs, std::vector<gpu::uvec2>(fixture.stages.search.pairs.size(), untouched));
    find();
    const auto wanted = wantedPairs();
    expectPairs(fixture.stages.search.pairs.download(), parity() * fixture.stages.parameters.pairCapacity, wanted,
                wanted.size(), untouched);
    const gpu::Counters counters = fixture.counters();
    EXPECT_EQ(counters.pairCount, wanted.size());
    EXPECT_EQ(counters.problems, 0u);
    const auto dispatches = fixture.stages.dispatches.download();
    for (uint32_t k : {DISPATCH_PAIRS, DISPATCH_NEW_PAIRS}) EXPECT_EQ(dispatches[k].x, groupsFor(wanted.size()));
}

TEST_P(PairLists, EachSecondParticleRefersToItsPairsInAscendingOrder)
{
    find();
    expectBegins(fixture.stages.search.pairReferences.download(), wantedReferences(), 0);
}

TEST_P(PairLists, ReferencesDoNotDependOnTheOrderOfArrival)
{
    find();
    const auto before = fixture.stages.search.pairReferences.download();
    const auto counts = fixture.stages.search.listCounts.download();
    auto entries = fixture.candidates();
    for (gpu::uvec4& candidate : entries) candidate.w = counts[count() + fixture.rankOf(candidate.y)] - 1 - candidate.w;
    std::ranges::reverse(entries);
    fixture.stages.search.candidates.write(entries.data(), entries.size() * sizeof entries[0], 0);
    fixture.fillLists();
    EXPECT_EQ(fixture.stages.search.pairReferences.download(), before);
}

TEST_P(PairLists, MorePairsThanThereIsRoomForAreReportedAndLeftOut)
{
    constexpr uint32_t ROOM = 1001;
    fixture.narrow(fixture.stages.parameters.candidateCapacity, ROOM, fixture.stages.parameters.colliderPairCapacity);
    const gpu::uvec2 untouched{77, 78};
    const gpu::vec4 untouchedVector{7, 7, 7, 7};
    Stages& b = fixture.stages;
    fill(b.search.pairs, std::vector<gpu::uvec2>(b.search.pairs.size(), untouched));
    fill(b.search.pairReferences, std::vector<uint32_t>(b.search.pairReferences.size(), 99));
    fill(b.contacts.pairSides, std::vector<gpu::uvec4>(b.contacts.pairSides.size(), gpu::uvec4{9, 9, 9, 9}));
    for (auto* buffer : {&b.contacts.pairArms, &b.contacts.pairImpulses})
        fill(*buffer, std::vector<gpu::vec4>(buffer->size(), untouchedVector));
    find();
    const auto wanted = wantedPairs();
    ASSERT_GT(wanted.size(), ROOM);
    EXPECT_EQ(fixture.counters().problems, PROBLEM_PAIRS);
    EXPECT_EQ(fixture.counters().wantedPairs, wanted.size());
    EXPECT_EQ(fixture.counters().pairCount, ROOM);
    EXPECT_EQ(b.dispatches.download()[DISPATCH_PAIRS].x, groupsFor(ROOM));
    expectPairs(b.search.pairs.download(), parity() * ROOM, wanted, ROOM, untouched);
    expectBegins(b.search.pairReferences.download(), wantedReferences(), 99);
    const auto sides = b.contacts.pairSides.download();
    for (size_t q = ROOM; q < sides.size(); ++q) ASSERT_EQ(sides[q].x, 9u) << "pair " << q;
    const auto arms = b.contacts.pairArms.download(), impulses = b.contacts.pairImpulses.download();
    for (size_t q = 2 * ROOM; q < arms.size(); ++q) ASSERT_EQ(vec3(arms[q]), vec3(untouchedVector)) << "arm " << q;
    for (size_t q = 0; q < impulses.size(); ++q) {
        const bool filled = q >= parity() * ROOM && q < (parity() + 1) * ROOM;
        ASSERT_EQ(impulses[q].x == 7.0f, !filled) << "impulse " << q;
    }
}

TEST_P(PairLists, ReferencesAreTheSameInEveryRunEvenWhereThereIsNoRoom)
{
    // The old contents of the arrivals come from another search, with its own order.
    constexpr uint32_t ROOM = 1001;
    fixture.narrow(fixture.stages.parameters.candidateCapacity, ROOM, fixture.stages.parameters.colliderPairCapacity);
    find();
    const auto first = fixture.stages.search.pairReferences.download();
    Random random(32);
    auto stale = fixture.stages.search.pairArrivals.download();
    for (uint32_t& q : stale) q = static_cast<uint32_t>(random.between(0, ROOM));
    fill(fixture.stages.search.pairArrivals, stale);
    fixture.fillLists();
    EXPECT_EQ(fixture.stages.search.pairReferences.download(), first);
}

std::string halfName(const testing::TestParamInfo<uint32_t>& half)
{
    return half.param == 0 ? "FirstHalf" : "SecondHalf";
}

INSTANTIATE_TEST_SUITE_P(Halves, PairLists, testing::Values(0u, 1u), halfName);

}  // namespace

}  // namespace knuckle::test
