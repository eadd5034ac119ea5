#include "sim/solver/workload.h"

#include "app/commands/table2_world.h"
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
    // Two cores are 1.55 times as fast as one, so they save 0.355 of 10 ms; 100 dispatches.
    EXPECT_EQ(chooseDriverThreads({100, 10}, 2, 0.0354).count, 2u);
    EXPECT_EQ(chooseDriverThreads({100, 10}, 2, 0.0356).count, 0u);
    EXPECT_EQ(chooseDriverThreads({100, 10}, 16, 0.0356).count, 16u) << "they save 0.89 of it";
    EXPECT_EQ(chooseDriverThreads({100, 1000}, 1, 0.0).count, 0u);
    EXPECT_NE(chooseDriverThreads({100, 10}, 2, 0.05).reason.find("3.5 ms a frame"), std::string::npos);
}

TEST(DriverThreads, WakingThemTakesTime)
{
    const double one = wakeTime(1);
    EXPECT_GT(one, 1e-4) << "no two context switches are that fast [ms]";
    EXPECT_LT(one, 1000.0);
}

}  // namespace

}  // namespace knuckle::test
