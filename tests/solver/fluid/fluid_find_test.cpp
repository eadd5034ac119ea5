#include <algorithm>
#include <set>
#include <utility>

#include "tests/solver/fluid/fluid_fixture.h"

namespace knuckle::test {

namespace {

/// On a lattice that is wide enough and on one that wraps too early.
class FluidFind : public testing::TestWithParam<bool> {
protected:
    FluidFind()
    {
        fixture.wrap(wrapped());
        fixture.findNeighbours();
    }
    bool wrapped() const { return GetParam(); }
    uint32_t particle(uint32_t slot) const { return fixture.slotParticles[slot]; }
    /// The particles that a slot lists: its fluid neighbours or its solid ones, which are at the end.
    std::vector<uint32_t> listed(uint32_t slot, bool fluid) const
    {
        const gpu::uvec2 counts = fixture.slotCounts[slot];
        std::vector<uint32_t> found;
        for (uint32_t n = 0; n < (fluid ? counts.x : counts.y); ++n)
            found.push_back(particle(fixture.entry(slot, fluid ? n : fixture.parameters().fluidSlots - 1 - n)));
        std::sort(found.begin(), found.end());
        return found;
    }
    /// Largest distance at which two particles may act on each other [m].
    double limit(uint32_t i, bool fluid) const
    {
        const gpu::StepParameters& p = fixture.parameters();
        return fluid && fixture.isFluid(i) ? p.fluidReach : p.fluidListReach;
    }
    /// Twice the two quanta of packed places (256 a cell) by which limits are raised.
    double slack() const { return 4.0 / (256.0 * fixture.parameters().inverseFluidCell); }
    /// Listed particles that only look near: three cells away or more.
    std::vector<uint32_t> farOff(uint32_t i, const std::vector<uint32_t>& found) const
    {
        std::vector<uint32_t> far;
        const double cells = (3.0 - 2.0 / 256.0) / fixture.parameters().inverseFluidCell;
        for (uint32_t j : found)
            if ((fixture.place(i) - fixture.place(j)).norm() > cells) far.push_back(j);
        return far;
    }
    static bool holds(const std::vector<uint32_t>& sorted, const std::vector<uint32_t>& wanted)
    {
        return std::includes(sorted.begin(), sorted.end(), wanted.begin(), wanted.end());
    }

    FluidFixture fixture;
};

TEST_P(FluidFind, EveryParticleHasOneSlot)
{
    auto particles = fixture.slotParticles;
    const auto slots = fixture.stages.fluids->particleSlots.download();
    for (uint32_t k = 0; k < particles.size(); ++k) ASSERT_EQ(slots[particles[k]], k);
    std::sort(particles.begin(), particles.end());
    for (uint32_t i = 0; i < fixture.count(); ++i) ASSERT_EQ(particles[i], i);
}

TEST_P(FluidFind, ListsAllNeighboursAndNoneThatIsFarther)
{
    size_t fluids = 0, solids = 0, farAway = 0;
    for (uint32_t k = 0; k < fixture.count(); ++k) {
        const uint32_t i = particle(k);
        for (bool fluid : {true, false}) {
            auto found = listed(k, fluid);
            if (!fluid && !fixture.isFluid(i)) {
                ASSERT_TRUE(found.empty()) << "solid " << i << " lists solids";
                continue;
            }
            const double reach = limit(i, fluid);
            ASSERT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end()) << i << " lists one twice";
            ASSERT_TRUE(holds(found, fixture.near(i, fluid, reach))) << "one is missing of " << i;
            const auto far = farOff(i, found);
            farAway += far.size();
            std::erase_if(found, [&](uint32_t j) { return std::ranges::find(far, j) != far.end(); });
            ASSERT_TRUE(holds(fixture.near(i, fluid, reach + slack()), found)) << "one is too far of " << i;
            (fluid ? fluids : solids) += found.size();
        }
    }
    EXPECT_GT(fluids, 20000u);
    EXPECT_GT(solids, 1500u);
    EXPECT_EQ(farAway > 100, wrapped());
    EXPECT_TRUE(farAway == 0 || wrapped()) << farAway;
    EXPECT_EQ(fixture.counters().problems, 0u);
}

TEST_P(FluidFind, WhoListsAnotherIsListedByIt)
{
    std::set<std::pair<uint32_t, uint32_t>> pairs;
    for (uint32_t k = 0; k < fixture.count(); ++k)
        for (bool fluid : {true, false})
            for (uint32_t j : listed(k, fluid)) pairs.insert({particle(k), j});
    for (const auto& [i, j] : pairs)
        ASSERT_TRUE(pairs.contains({j, i}) || !farOff(i, {j}).empty()) << i << " lists " << j;
}

TEST_P(FluidFind, BehindItsLastFluidNeighbourASlotListsItself)
{
    std::set<uint32_t> rests;
    for (uint32_t k = 0; k < fixture.count(); ++k) {
        rests.insert(fixture.slotCounts[k].x % 4);
        for (uint32_t n = fixture.slotCounts[k].x; n % 4 != 0; ++n) ASSERT_EQ(fixture.entry(k, n), k) << "slot " << k;
    }
    EXPECT_EQ(rests.size(), 4u);
}

TEST_P(FluidFind, WhatHasNoRoomIsReported)
{
    // The kernel is told of less room than the stages have, so lists have that distance.
    fixture.stages.parameters.fluidSlots = 32;
    fixture.setParameters();
    const auto whole = fixture.slotCounts;
    fixture.findNeighbours();
    uint32_t most = 0, cut = 0;
    for (uint32_t k = 0; k < fixture.count(); ++k) {
        const gpu::uvec2 counts = fixture.slotCounts[k], all = whole[k];
        most = std::max(most, all.x + all.y);
        ASSERT_LE((counts.x + 3) / 4 * 4 + counts.y, 32u);
        const bool fits = (all.x + 3) / 4 * 4 + all.y <= 32u;
        cut += !fits;
        if (fits) {
            ASSERT_TRUE(counts.x == all.x && counts.y == all.y) << "slot " << k;
        } else {
            ASSERT_GT(counts.x + counts.y, 24u) << "slot " << k;
        }
        for (uint32_t j : listed(k, true)) {
            const double r = (fixture.place(j) - fixture.place(particle(k))).norm();
            ASSERT_TRUE(r < 1.01 * fixture.parameters().fluidListReach || (wrapped() && r > 0.3)) << r;
        }
    }
    EXPECT_GT(cut, 100u);
    EXPECT_EQ(fixture.counters().problems, PROBLEM_FLUID);
    EXPECT_EQ(fixture.counters().wantedNeighbours, most + 3);
}

INSTANTIATE_TEST_SUITE_P(Lattices, FluidFind, testing::Bool(),
                         [](const auto& wrapped) { return wrapped.param ? "WrappedEarly" : "Wide"; });

}  // namespace

}  // namespace knuckle::test
