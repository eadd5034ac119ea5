#include "render/between_steps.h"

#include <cmath>

#include "sim/base/angles.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float STEP = 1.0f / 60.0f;

/// A body of one particle.
World moving(const Vector3f& place, const Vector3f& velocity, float turn = 0.0f)
{
    StillWorld still(0.05f);
    still.addBody({Vector3f::Zero()}, place, Quaternionf(Eigen::AngleAxisf(turn, Vector3f::UnitY())), velocity);
    still.world.settings.timeStep = STEP;
    return still.world;
}

ViewState between(const World& before, const World& after, double part)
{
    Gpu& gpu = sharedGpu();
    const StillBuffers first(before), second(after);
    BetweenSteps steps(gpu, before);
    steps.begin(first.view());
    steps.at(second.view(), part);
    ViewState view;
    view.positions.resize(1);
    view.velocities.resize(1);
    view.bodyCentres.resize(1);
    view.bodyRotations.resize(1);
    steps.read(view);
    return view;
}

Vector3f placeOf(const gpu::vec4& v)
{
    return {v.x, v.y, v.z};
}

TEST(BetweenSteps, ParticlesGoOnCubics)
{
    const Vector3f start(1, 2, 3), velocity(2, 1, 0), gravity(0, -9.81f, 0), jerk(0, 0, 1000);
    const auto place = [&](float time) -> Vector3f {
        return start + time * velocity + 0.5f * time * time * gravity + time * time * time * jerk;
    };
    const Vector3f faster = velocity + STEP * gravity + 3 * STEP * STEP * jerk;
    const World before = moving(start, velocity), after = moving(place(STEP), faster);
    for (const float part : {0.25f, 0.5f, 0.9f}) {
        const ViewState view = between(before, after, part);
        EXPECT_NEAR((placeOf(view.positions[0]) - place(part * STEP)).norm(), 0, 1e-6f) << part;
        EXPECT_NEAR((placeOf(view.velocities[0]) - velocity - part * (faster - velocity)).norm(), 0, 1e-5f) << part;
        // Where bodies and skins are, a step is straight.
        const Vector3f straight = start + part * (place(STEP) - start);
        EXPECT_NEAR((placeOf(view.bodyCentres[0]) - straight).norm(), 0, 1e-6f) << part;
    }
}

TEST(BetweenSteps, WhatBouncesGoesNoDeeperThanAnEighthOfItsWay)
{
    // It comes down at 5 m/s and rises at 4 m/s: a cubic of these speeds would go 1.8 cm below both places.
    const World before = moving({0, 0.06f, 0}, {0, -5, 0}), after = moving({0, 0.05f, 0}, {0, 4, 0});
    for (const float part : {0.2f, 0.5f, 0.8f})
        EXPECT_GE(between(before, after, part).positions[0].y, 0.05f - 0.01f / 8) << part;
}

TEST(BetweenSteps, BodiesTurnEvenly)
{
    const World before = moving({0, 0, 0}, {0, 0, 0}, 0.1f), after = moving({0, 0, 0}, {0, 0, 0}, 0.4f);
    const gpu::vec4 half = between(before, after, 0.5).bodyRotations[0],
                    third = between(before, after, 1.0 / 3).bodyRotations[0];
    EXPECT_NEAR(std::hypot(third.y, third.w), 1.0f, 1e-6f);
    EXPECT_NEAR(2 * std::atan2(half.y, half.w), 0.25f, 1e-5f);
    EXPECT_NEAR(2 * std::atan2(third.y, third.w), 0.2f, 2e-4f);
}

}  // namespace
}  // namespace knuckle::test
