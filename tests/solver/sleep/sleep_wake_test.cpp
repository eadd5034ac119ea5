#include <algorithm>

#include "tests/solver/sleep/sleep_fixture.h"

namespace knuckle::test {

namespace {

class SleepWake : public testing::Test {
protected:
    std::vector<uint32_t> woken() const { return fixture.stages.sleep->islandsWoken.download(); }
    gpu::uvec4 moversDispatch() const { return fixture.stages.dispatches.download()[DISPATCH_MOVERS]; }
    /// Wakes some islands; the movers are not requested yet.
    std::vector<uint32_t> wakeSome(uint32_t ofHundred)
    {
        std::vector<uint32_t> some(fixture.assemblyCount());
        for (uint32_t a = 0; a < some.size(); ++a) some[a] = a * 7 % 100 < ofHundred;
        fill(fixture.stages.sleep->islandsWoken, some);
        const gpu::uvec4 none{0, 1, 1, 0};
        fixture.stages.dispatches.write(&none, sizeof none, DISPATCH_MOVERS * sizeof none);
        return some;
    }
    void expectWoken(bool freezes)
    {
        const auto islands = wakeSome(30);
        auto wanted = fixture.calms;
        uint32_t count = 0;
        for (uint32_t a = 0; a < wanted.size(); ++a) {
            if (!fixture.isAsleep(a) || islands[wanted[a].y] == 0) continue;
            if (freezes) wanted[a].x = 1;  // it has not moved itself
            else wanted[a] = {0, a};
            ++count;
        }
        EXPECT_GT(count, 50u);
        fixture.forAssemblies("sleep_wake_assembly", freezes ? Defines{{"FREEZE", "1"}} : Defines{});
        fixture.expectCalms(fixture.stages.sleep->assemblyCalm.download(), wanted);
        EXPECT_EQ(moversDispatch().x, groupsFor(fixture.moverCount()));
    }

    SleepFixture fixture;
};

TEST_F(SleepWake, WhatMovesWakesTheIslandOfWhatSleepsThatItComesNear)
{
    std::vector<uint32_t> wanted(fixture.assemblyCount(), 0);
    for (const TestContact& c : fixture.pairs) {
        const uint32_t a = fixture.assemblyOf(fixture.moverOf[c.first]);
        const uint32_t b = fixture.assemblyOf(fixture.moverOf[c.second]);
        if (fixture.isAsleep(a) && fixture.calms[b].x == 0) wanted[fixture.calms[a].y] = 1;
        if (fixture.isAsleep(b) && fixture.calms[a].x == 0) wanted[fixture.calms[b].y] = 1;
    }
    fixture.runSleep("sleep_wake_island", fixture.pairs.size());
    EXPECT_EQ(woken(), wanted);
    EXPECT_GT(std::count(wanted.begin(), wanted.end(), 1u), 50);
}

TEST_F(SleepWake, AnIslandWakesAsAWholeAndItsMoversStartFromTheirContacts)
{
    expectWoken(false);
}

TEST_F(SleepWake, WhatWasFrozenIsAwakeButWakesNobody)
{
    expectWoken(true);
}

TEST_F(SleepWake, WhereNothingWakesNoMoverStartsAnew)
{
    wakeSome(0);
    fixture.forAssemblies("sleep_wake_assembly");
    fixture.expectCalms(fixture.stages.sleep->assemblyCalm.download(), fixture.calms);
    EXPECT_EQ(moversDispatch().x, 0u);
}

}  // namespace

}  // namespace knuckle::test
