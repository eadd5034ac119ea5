#include <algorithm>

#include "tests/solver/sleep/sleep_fixture.h"

namespace knuckle::test {

namespace {

class Sleep : public testing::Test {
protected:
    /// Of all that ends a step.
    void endStep()
    {
        fixture.runSleep("sleep_mover", fixture.moverCount());
        fixture.runSleep("sleep_island", fixture.pairs.size());
        fixture.forAssemblies("sleep_update");
    }
    SleepFixture fixture;
};

TEST_F(Sleep, AnAssemblyIsAsCalmAsTheLeastCalmOfItsMovers)
{
    std::vector<gpu::uvec2> wanted;
    for (uint32_t a = 0; a < fixture.assemblyCount(); ++a) wanted.push_back({fixture.calmSteps(), a});
    fixture.setNext(wanted);
    // Half are slow; for bodies this depends on their spin.
    auto velocities = fixture.randomFields(0.005f, 0.12f, 311);
    Random random(312);
    const double limit = fixture.stages.parameters.sleepSpeed;
    uint32_t spinning = 0, edges = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        const uint32_t start = fixture.fieldStart(m);
        if (!fixture.isBody(m) && random.between(0, 1) < 0.5f) velocities[start] = packed(0.05f * random.direction());
        if (fixture.isFixed(m)) velocities[start] = {1, 0, 0, 0};  // counts for nothing
        const Field v = fixture.field(velocities, m);
        // No particle of it is faster.
        const double fastest = v.t.norm() + fixture.radius(m) * v.f.norm();
        edges += std::abs(fastest - limit) < 1e-6 * limit;
        spinning += fastest > limit && v.t.norm() < limit;
        if (fixture.isFixed(m)) continue;
        gpu::uvec2& next = wanted[fixture.assemblyOf(m)];
        next.x = std::min(next.x, fastest > limit ? 0u : fixture.calms[fixture.assemblyOf(m)].x + 1);
    }
    ASSERT_EQ(edges, 0u);
    EXPECT_GT(spinning, 2u);
    fill(fixture.stages.bodies.moverVelocities, velocities);
    fixture.runSleep("sleep_mover", fixture.moverCount());
    fixture.expectCalms(fixture.nextCalms(), wanted);
}

TEST_F(Sleep, WhatTouchesIsOneIslandAndHardlyCalmerThanItsNeighbours)
{
    auto wanted = fixture.next;
    for (const TestContact& c : fixture.pairs) {
        const uint32_t a = fixture.moverOf[c.first], b = fixture.moverOf[c.second];
        if (c.impulse.w <= 0.0f || fixture.isFixed(a) || fixture.isFixed(b)) continue;
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
            gpu::uvec2& next = wanted[fixture.assemblyOf(one)];
            const gpu::uvec2 calm = fixture.calms[fixture.assemblyOf(other)];
            next = {std::min(next.x, calm.x + 1), std::min(next.y, calm.y)};
        }
    }
    fixture.runSleep("sleep_island", fixture.pairs.size());
    fixture.expectCalms(fixture.nextCalms(), wanted);
}

TEST_F(Sleep, AnUpdateTakesOverWhatAStepHasFoundAndBeginsAnew)
{
    std::vector<gpu::uvec2> wanted, fresh;
    for (uint32_t a = 0; a < fixture.assemblyCount(); ++a) {
        const uint32_t steps = std::min(fixture.next[a].x, fixture.calmSteps());
        // An assembly that has moved lately is an island of its own.
        wanted.push_back({steps, steps < fixture.calmSteps() / 2 ? a : fixture.next[a].y});
        fresh.push_back({fixture.calmSteps(), a});
    }
    fill(fixture.stages.sleep->islandsWoken, std::vector<uint32_t>(fixture.assemblyCount(), 1));
    fixture.forAssemblies("sleep_update");
    fixture.expectCalms(fixture.stages.sleep->assemblyCalm.download(), wanted);
    fixture.expectCalms(fixture.nextCalms(), fresh);
    for (uint32_t woken : fixture.stages.sleep->islandsWoken.download()) ASSERT_EQ(woken, 0u);
}

/// A row of 70 loose particles, each touching the next; the first never rests.
TEST_F(Sleep, ACountTellsOverHowManyContactsTheNearestThingThatMovesIsAway)
{
    constexpr uint32_t COUNT = 70;
    const auto first = static_cast<uint32_t>(fixture.world.particles.size()) - COUNT;
    std::vector<TestContact> row;
    for (uint32_t k = first; k + 1 < first + COUNT; ++k)
        row.push_back({.first = k, .second = k + 1, .impulse = {0, 0, 0, 1}});
    fixture.setPairs(row);
    std::vector<gpu::uvec2> awake;
    for (uint32_t a = 0; a < fixture.assemblyCount(); ++a) awake.push_back({0, a});
    fixture.setCalms(awake);
    for (gpu::uvec2& next : awake) next.x = fixture.calmSteps();
    fixture.setNext(awake);
    std::vector<gpu::vec4> velocities(fixture.stages.bodies.moverVelocities.size(), gpu::vec4{0, 0, 0, 0});
    velocities[fixture.fieldStart(fixture.moverOf[first])] = {1, 0, 0, 0};
    fill(fixture.stages.bodies.moverVelocities, velocities);
    for (uint32_t step = 0; step < 2 * COUNT; ++step) endStep();
    const auto found = fixture.stages.sleep->assemblyCalm.download();
    for (uint32_t k = 0; k < COUNT; ++k) {
        const gpu::uvec2 calm = found[fixture.assemblyOf(fixture.moverOf[first + k])];
        EXPECT_EQ(calm.x, std::min(k, fixture.calmSteps())) << "particle " << k;
        // The last one that has moved lately gives the island after it its name.
        const uint32_t name = std::min(k, fixture.calmSteps() / 2 - 1);
        EXPECT_EQ(calm.y, fixture.assemblyOf(fixture.moverOf[first + name])) << "particle " << k;
    }
}

}  // namespace

}  // namespace knuckle::test
