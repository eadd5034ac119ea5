#include <cmath>

#include "tests/physics/animation/moving_fixture.h"
#include "tests/physics/closed/round_fixture.h"

namespace knuckle::test {

namespace {

constexpr float RADIUS = 2 * DIAMETER;

/// A ball on the floor that starts at 2 m/s with a spin forwards [rad/s].
World bowlingBall(float forwards)
{
    WorldBuilder builder = builderOf({}, 0.2f);
    builder.addCollider(floorPlane(0.2f));
    addRoundBody(builder, {RADIUS, 0}, {Vector3f(0, RADIUS, 0)}, {2, 0, 0}, {0, 0, -forwards});
    return builder.build();
}

}  // namespace

/// It slides until mu g has slowed it and spun it up to 5/7 of its speed, after 2 v / 7 mu g = 0.29 s and on a way of
/// 12 v^2 / 49 mu g. Thrown with a spin of w backwards it ends at (5 v - 2 R w) / 7, and so comes back.
TEST(ClosedBalls, ABallThatSlidesRollsOnWithFiveSeventhsOrComesBack)
{
    for (const float spin : {0.0f, -30.0f}) {
        const World world = bowlingBall(spin);
        Solver solver(gpu(), world);
        const double last = (5 * 2.0 + 2 * double{RADIUS} * spin) / 7, brake = 0.2 * GRAVITY;
        const double sliding = (2.0 - last) / brake, way = (4.0 - last * last) / (2 * brake);
        run(solver, world, 1.5);
        const BodyState ball = solver.readBodies()[0];
        // The pressure of its weight takes some ten substeps to build up, 0.04 s at 2 m/s^2: 2 % of the first speed. A
        // spin that it starts with grows by (w h)^2 / 2 in the first substep, here 0.8 %, 0.013 m/s in the end.
        EXPECT_NEAR(ball.velocity.x(), last, 0.02 * 2.0) << spin;
        EXPECT_NEAR(ball.angularVelocity.z(), -last / RADIUS, 0.02 * 2.0 / RADIUS) << spin;
        EXPECT_NEAR(ball.position.x(), way + last * (1.5 - sliding), 0.04 * 2.0) << spin;
    }
}

/// On a table that turns with W a solid ball rolls in a circle at 2/7 of W, whatever its speed.
TEST(ClosedBalls, ABallRollsInCirclesOnATurntable)
{
    constexpr float SPIN = 3.0f, SPEED = 0.5f;
    WorldBuilder builder = builderOf({}, 0.5f);
    addRoundBody(builder, {RADIUS, 0}, {Vector3f(0, RADIUS, 0)}, {SPEED, 0, 0}, {0, 0, -SPEED / RADIUS});
    addMovingBox(builder, {0, -0.2f, 0}, {3, 0.2f, 3}, motionOf(4, [&](float t) {
                     return Pose{{0, 0, 0}, Quaternionf(Eigen::AngleAxisf(SPIN * t, Vector3f::UnitY()))};
                 }));
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.5);
    const BodyState ball = solver.readBodies()[0];
    const double turned = std::atan2(-ball.velocity.z(), ball.velocity.x()), truth = 2.0 / 7.0 * SPIN * 2.5;
    // First order takes the acceleration where the substep begins: W h 2/7 / 2 of the speed each radian. What builds
    // up of its weight first lags by 0.04 s.
    EXPECT_NEAR(turned, truth, 0.03 * truth);
    EXPECT_NEAR(ball.velocity.norm(), SPEED, 0.02 * SPEED);
    const double circle = SPEED / (2.0 / 7.0 * SPIN);
    EXPECT_NEAR(std::hypot(ball.position.x(), ball.position.z() + circle), circle, 0.03 * circle);
}

/// From 1 m at e = 0.7 it comes to rest after sqrt(2 H / g) (1 + e) / (1 - e) = 2.56 s.
TEST(ClosedBalls, ABouncingBallComesToRestInItsTime)
{
    constexpr double E = 0.7, HEIGHT = 1.0;
    WorldBuilder builder = builderOf({}, 0.2f, static_cast<float>(E));
    builder.addCollider(floorPlane());
    addRoundBody(builder, {RADIUS, 0}, {Vector3f(0, RADIUS + static_cast<float>(HEIGHT), 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    const double fall = std::sqrt(2 * HEIGHT / GRAVITY), step = world.settings.timeStep;
    // The last bounce that rises by more than 5 mm is the seventh; it ends, each bounce e times as long as the one
    // before, at:
    int bounces = 0;
    for (double height = HEIGHT * E * E; height > 0.005; height *= E * E) ++bounces;
    double truth = fall, last = 0;
    for (int k = 1; k <= bounces; ++k) truth += 2 * fall * std::pow(E, k);
    for (int k = 1; k * step < 3.0; ++k) {
        run(solver, world, step);
        if (solver.readBodies()[0].position.y() - RADIUS > 0.0025f) last = k * step;
    }
    // Each bounce is found up to a substep late, and v that is then too high by g h / 2 shortens none: seven of them
    // are 30 ms; the next bounce, of 2 mm, may be seen or not, 0.08 s.
    EXPECT_NEAR(last, truth, 0.04 * truth);
    // The whole time, once nothing rises any more.
    EXPECT_LT(std::abs(solver.readBodies()[0].velocity.y()), 0.02f);
}

/// Of two smooth balls, e = 1, the one at rest leaves along the line of their centres and the other across it.
TEST(ClosedBalls, TwoBallsPartAtARightAngle)
{
    for (const float offset : {0.5f, 1.2f}) {
        WorldBuilder builder = builderOf(weightless(), 0.0f, 1.0f);
        addRoundBody(builder, {RADIUS, 0}, {Vector3f(-1, offset * RADIUS, 0)}, {2, 0, 0});
        addRoundBody(builder, {RADIUS, 0}, {});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 1.0);
        const Vector3f first = solver.readBodies()[0].velocity, second = solver.readBodies()[1].velocity;
        const double sine = 0.5 * offset, cosine = std::sqrt(1 - sine * sine);
        // In the substep in which they meet they come by up to 2 m/s h = 8 mm too near, of 0.4 m: 0.02 rad.
        EXPECT_NEAR(second.norm(), 2 * cosine, 0.03 * 2) << offset;
        EXPECT_NEAR(first.norm(), 2 * sine, 0.03 * 2) << offset;
        EXPECT_NEAR(first.normalized().dot(second.normalized()), 0, 0.03) << offset;
        EXPECT_NEAR(std::atan2(-second.y(), second.x()), std::asin(sine), 0.03) << offset;
    }
}

}  // namespace knuckle::test
