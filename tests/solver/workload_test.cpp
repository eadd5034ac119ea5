#include "sim/solver/workload.h"

#include "app/bench/bench_worlds.h"
#include "sim/solver/solver.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

double dispatchesOfAStep(const World& world)
{
    Solver solver(gpu(), world);
    solver.timePasses();
    solver.step();
    uint64_t count = 0;
    for (const PassTime& pass : solver.passTimes()) count += pass.count;
    return static_cast<double>(count);
}

TEST(Workload, OfAStepIsNearToWhatTheStepDispatches)
{
    Settings steps = paperSettings(), thread = paperSettings(), many;
    thread.reduction = ReductionKind::Thread;
    many.iterations = 6;
    for (const Settings& settings : {Settings{}, many, steps, thread}) {
        const World world = table2World(4, settings);
        const double counted = dispatchesOfAStep(world);
        EXPECT_NEAR(stepWorkload(world).dispatches, counted, counted / 3);
    }
}

TEST(Workload, GrowsWithTheWorld)
{
    EXPECT_NEAR(stepWorkload(table2World(8, {})).milliseconds, 2 * stepWorkload(table2World(4, {})).milliseconds, 1e-6);
    EXPECT_LT(stepWorkload(table2World(4, {})).milliseconds,
              stepWorkload(table2World(4, paperSettings())).milliseconds);
}

TEST(DriverThreads, AreThereWhereTheyGainMoreThanWakingThemCosts)
{
    // Two cores are 1.55 times as fast as one, so they save 0.355 of 10 ms; 100 dispatches. Nothing is drawn.
    const FrameWork work{{100, 10}, {}};
    EXPECT_EQ(chooseDriverThreads(work, 2, 0.0354).count, 2u);
    EXPECT_EQ(chooseDriverThreads(work, 2, 0.0356).count, 0u);
    EXPECT_EQ(chooseDriverThreads(work, 16, 0.0356).count, 16u) << "they save 0.89 of it";
    EXPECT_EQ(chooseDriverThreads({{100, 1000}, {}}, 1, 0.0).count, 0u);
    EXPECT_FALSE(chooseDriverThreads(work, 2, 0.0354).drawAside);
}

TEST(DriverThreads, AFrameIsDrawnAsideWhereThatIsTheFastestOfFourWays)
{
    // Many dispatches and as much to draw: sequentially 20 ms without driver threads; aside 10 ms and two handovers.
    const FrameWork work{{1000, 10}, {10, 10}};
    const DriverThreads both = chooseDriverThreads(work, 2, 0.05);
    EXPECT_EQ(both.count, 0u);
    EXPECT_TRUE(both.drawAside);
    // Waking costs nothing: everything is as fast as the cores are, drawing aside too, less the cost of handovers.
    EXPECT_EQ(chooseDriverThreads(work, 2, 1e-6).count, 0u) << "two threads of the host do as well, on two cores";
    EXPECT_EQ(chooseDriverThreads({{10, 10}, {10, 100}}, 2, 1e-3).count, 2u) << "drawing alone takes both cores";
    // Handing over takes longer than drawing.
    EXPECT_FALSE(chooseDriverThreads({{1000, 10}, {10, 0.05}}, 2, 0.05).drawAside);
    EXPECT_FALSE(chooseDriverThreads(work, 1, 0.05).drawAside) << "one core";
    // The threads are given.
    EXPECT_EQ(chooseDriverThreads(work, 2, 0.05, true).count, 2u);
    EXPECT_TRUE(chooseDriverThreads(work, 2, 0.05, false).drawAside);
}

TEST(DriverThreads, WakingThemTakesTime)
{
    const double one = wakeTime(1);
    EXPECT_GT(one, 1e-4) << "no two context switches are that fast [ms]";
    EXPECT_LT(one, 1000.0);
}

}  // namespace

}  // namespace knuckle::test
