#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

Settings sleepy()
{
    Settings settings;
    settings.sleepSpeed = 0.02f;
    return settings;
}

/// A tower of cubes on the floor, and a cube that comes down on `target` after three seconds at 15 m/s and sideways at
/// 2 m/s.
World towerAndMissile(int cubes, const Vector3f& target)
{
    WorldBuilder builder = makeBuilder(sleepy());
    builder.addCollider(floorPlane());
    for (int k = 0; k < cubes; ++k)
        addBox(builder, {3, 3, 3}, {Vector3f(0, (1.5f + 3.0f * static_cast<float>(k)) * DIAMETER, 0)});
    const float up = 15.0f, along = 2.0f, flight = 2.0f * up / static_cast<float>(GRAVITY);
    addBox(builder, {4, 4, 4}, {target - Vector3f(along * flight, 0, 0)}, {along, up, 0});
    return builder.build();
}

/// Whether none, or all, of the first `count` bodies stand as still as only sleeping ones do.
bool allSleep(const std::vector<BodyState>& bodies, size_t count)
{
    for (size_t b = 0; b < count; ++b)
        if (bodies[b].velocity.norm() != 0.0f || bodies[b].angularVelocity.norm() != 0.0f) return false;
    return true;
}

bool noneSleeps(const std::vector<BodyState>& bodies, size_t count)
{
    for (size_t b = 0; b < count; ++b)
        if (bodies[b].velocity.norm() == 0.0f) return false;
    return true;
}

}  // namespace

TEST(Sleep, ATowerSleepsAndWakesAsAWhole)
{
    const World world = towerAndMissile(5, {0.0f, 15.0f * DIAMETER, 0});
    Solver solver(gpu(), world);
    run(solver, world, 2.5);
    const auto before = solver.readBodies();
    EXPECT_TRUE(allSleep(before, 5));
    // It falls on the topmost after 3.06 s at most; the lowest, four contacts away, wakes in the same step.
    int steps = 0;
    while (allSleep(solver.readBodies(), 5) && steps++ < 60) run(solver, world, 1.0 / 60.0);
    EXPECT_TRUE(noneSleeps(solver.readBodies(), 5));
    EXPECT_LT(steps, 60);
    // Nothing gets into a tower while the tower has yet to wake.
    EXPECT_LT(solver.measure().worstPenetration, 0.8f * DIAMETER);
}

TEST(Sleep, NothingStaysInTheAirWhenWhatItSleepsOnIsKnockedAway)
{
    const World world = towerAndMissile(2, {-2.6f * DIAMETER, 2.0f * DIAMETER, 0});
    Solver solver(gpu(), world);
    run(solver, world, 2.9);
    EXPECT_TRUE(allSleep(solver.readBodies(), 2));
    run(solver, world, 4.0);
    const auto bodies = solver.readBodies();
    const Vector3f apart = bodies[1].position - bodies[0].position;
    const bool stacked = std::hypot(apart.x(), apart.z()) < 2.9f * DIAMETER;
    EXPECT_FALSE(stacked) << "the missile missed: " << apart.transpose();
    for (size_t b = 0; b < 2; ++b) EXPECT_LT(bodies[b].position.y(), 3.5f * DIAMETER) << "body " << b;
}

TEST(Sleep, EndsTheSameInEveryRun)
{
    uint64_t hashes[2];
    for (uint64_t& hash : hashes) {
        const World world = towerAndMissile(3, {0.0f, 9.0f * DIAMETER, 0});
        Solver solver(gpu(), world);
        run(solver, world, 3.5);
        hash = solver.stateHash();
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace knuckle::test
