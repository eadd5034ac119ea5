#include <cmath>

#include "tests/physics/animation/moving_fixture.h"

namespace knuckle::test {

namespace {

constexpr float HALF = 1.5f * DIAMETER, WAITS = 2.0f;

Settings resting(bool freezes)
{
    Settings settings;
    if (freezes) settings.freeze = 0.5f;
    else settings.sleepSpeed = 0.02f;
    return settings;
}

/// Two cubes, one on the other, on a lift that waits and then rises. @param speed [m/s].
World waitingLift(const Settings& settings, float speed)
{
    WorldBuilder builder = makeBuilder(settings);
    for (const float height : {HALF, 3 * HALF}) addBox(builder, {3, 3, 3}, {{0, height, 0}});
    addMovingBox(builder, {0, -0.1f, 0}, {0.5f, 0.1f, 0.5f}, motionOf(WAITS + 2, [&](float t) {
                     return Pose{{0, speed * std::max(t - WAITS, 0.0f), 0}};
                 }));
    return builder.build();
}

float fastest(Solver& solver)
{
    float speed = 0.0f;
    for (const BodyState& body : solver.readBodies()) speed = std::max(speed, body.velocity.norm());
    return speed;
}

class LiftWithSleepers : public testing::TestWithParam<bool> {};

}  // namespace

/// The keys of two seconds of standing are equal, so cubes on it sleep; when it starts, however slowly, they wake. 8
/// mm/s is below the threshold of calm.
TEST_P(LiftWithSleepers, WhatSleepsOnALiftGoesWithItWhenItStarts)
{
    for (const float speed : {0.5f, 0.008f}) {
        const World world = waitingLift(resting(GetParam()), speed);
        Solver solver(gpu(), world);
        run(solver, world, WAITS - 0.1);
        EXPECT_EQ(fastest(solver), 0.0f) << "they sleep";
        run(solver, world, 2.1);
        const auto bodies = solver.readBodies();
        for (size_t b = 0; b < 2; ++b)
            EXPECT_NEAR(bodies[b].position.y(), 2.0f * speed + (1 + 2 * static_cast<float>(b)) * HALF, 0.03f * DIAMETER)
                << speed << " m/s, cube " << b;
    }
}

/// They sleep again once it stands.
TEST_P(LiftWithSleepers, TheySleepAgainWhereItStops)
{
    const World world = waitingLift(resting(GetParam()), 0.2f);
    Solver solver(gpu(), world);
    run(solver, world, WAITS + 1.5);
    EXPECT_GT(fastest(solver), 0.1f);
    run(solver, world, 3.0);
    EXPECT_EQ(fastest(solver), 0.0f);
}

INSTANTIATE_TEST_SUITE_P(MovingCollider, LiftWithSleepers, testing::Bool(),
                         [](const auto& freezes) { return std::string(freezes.param ? "Freeze" : "Sleep"); });

}  // namespace knuckle::test
