#include <cmath>

#include "tests/physics/animation/moving_fixture.h"
#include "tests/physics/closed/round_fixture.h"

namespace knuckle::test {

namespace {

/// A capsule as a rod: its ends' centres are HALF from its middle.
constexpr float RADIUS = 1.5f * DIAMETER, HALF = 0.6f;

/// I / m of a solid capsule across its axis [m2].
double capsuleInertia()
{
    const double r = RADIUS, h = HALF, middle = 2 * h, caps = 4.0 / 3.0 * r, all = middle + caps;
    const double cylinder = r * r / 4 + h * h / 3, ball = 0.4 * r * r + h * h + 0.75 * r * h;
    return (middle * cylinder + caps * ball) / all;
}

/// The capsule leans by `angle` above the level, its lower end towards +x on a smooth floor.
World leaningRod(double angle, bool atWall)
{
    WorldBuilder builder = builderOf({}, 0.0f);
    builder.addCollider(floorPlane(0.0f));
    if (atWall) {
        Collider wall = floorPlane(0.0f);
        wall.shape = ColliderShape::Box;
        wall.halfExtents = {0.5f, 3, 3};
        wall.position = {-0.5f, 3, 0};
        builder.addCollider(wall);
    }
    const auto turn = static_cast<float>(M_PI / 2 - angle);
    const Vector3f middle(RADIUS + HALF * std::sin(turn), RADIUS + HALF * std::cos(turn), 0);
    addRoundBody(builder, {RADIUS, HALF}, {middle, Quaternionf(Eigen::AngleAxisf(turn, Vector3f::UnitZ()))});
    return builder.build();
}

}  // namespace

/// A ladder on a smooth floor at a smooth wall leaves the wall where its end is 2/3 as high as at first, whatever its
/// inertia. Until then its middle goes round the corner at a, w^2 = 2 g a (s0 - s) / (a^2 + I/m), s the sine of its
/// angle, and from then on nothing changes its speed along the floor, a s w.
TEST(ClosedRods, ALadderLeavesItsWallAtTwoThirdsOfItsHeight)
{
    const double angle = 1.0, first = std::sin(angle), a = HALF;
    const World world = leaningRod(angle, true);
    Solver solver(gpu(), world);
    const double truth = a * 2.0 / 3.0 * first * std::sqrt(2 * GRAVITY * a * first / 3.0 / (a * a + capsuleInertia()));
    double fastest = 0, leftAt = 0;
    for (int k = 0; k < 120; ++k) {
        run(solver, world, world.settings.timeStep);
        const BodyState rod = solver.readBodies()[0];
        if (rod.position.y() - RADIUS < 0.1f * HALF) break;
        if (rod.velocity.x() > fastest * 1.002) leftAt = (rod.position.y() - RADIUS) / a;
        fastest = std::max(fastest, double{rod.velocity.x()});
    }
    // First order, in substeps of 4 ms of a fall of 0.6 s: about 1 % of the speed. Near its greatest value the speed
    // grows as slowly as a parabola: 0.2 % are 6 % of the height.
    EXPECT_NEAR(fastest, truth, 0.02 * truth);
    EXPECT_NEAR(leftAt, 2.0 / 3.0 * first, 0.08 * first);
}

/// On a smooth floor a rod's middle falls straight down, w^2 = 2 g a (s0 - s) / (a^2 (1 - s^2) + I/m).
TEST(ClosedRods, ARodOnIceFallsStraightDown)
{
    const double angle = 1.2, first = std::sin(angle), a = HALF;
    const World world = leaningRod(angle, false);
    Solver solver(gpu(), world);
    const float start = world.bodies[0].position.x();
    for (int k = 0; k < 120; ++k) {
        run(solver, world, world.settings.timeStep);
        const BodyState rod = solver.readBodies()[0];
        const double s = (rod.position.y() - RADIUS) / a;
        if (s < 0.05) break;
        EXPECT_NEAR(rod.position.x(), start, 1e-3f);  // rounding alone: nothing pushes it
        if (s > 0.5 * first) continue;
        const double truth = std::sqrt(2 * GRAVITY * a * (first - s) / (a * a * (1 - s * s) + capsuleInertia()));
        // As above.
        EXPECT_NEAR(std::abs(rod.angularVelocity.z()), truth, 0.02 * truth) << "at the sine " << s;
    }
}

/// A ball hits a free rod at b from its middle, e = 1: the blow is J = 2 v / (1/m + 1/M + b^2/I).
TEST(ClosedRods, ABlowBesideTheMiddleTurnsAndMovesARod)
{
    for (const float arm : {0.2f, 0.4f}) {
        WorldBuilder builder = builderOf(weightless(), 0.0f, 1.0f);
        addRoundBody(builder, {RADIUS, HALF}, {});
        addRoundBody(builder, {RADIUS, 0}, {Vector3f(-1, arm, 0)}, {2, 0, 0});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 0.5);
        const double rod = world.bodies[0].mass, ball = world.bodies[1].mass, inertia = rod * capsuleInertia();
        const double blow = 4.0 / (1 / rod + 1 / ball + double{arm} * arm / inertia);
        const auto bodies = solver.readBodies();
        // The rod turns by less than 0.01 rad in the substep in which they meet; restitution leaves a hundredth.
        EXPECT_NEAR(bodies[0].velocity.x(), blow / rod, 0.02 * blow / rod) << arm;
        EXPECT_NEAR(bodies[0].angularVelocity.z(), -blow * arm / inertia, 0.03 * blow * arm / inertia) << arm;
        EXPECT_NEAR(bodies[1].velocity.x(), 2 - blow / ball, 0.03 * 2) << arm;
    }
}

/// A table that speeds up at a slips away below a block by (a - mu g) t^2 / 2, or takes it along.
TEST(ClosedRods, ATableThatSpeedsUpLosesItsBlockBeyondItsFriction)
{
    constexpr float MU = 0.5f, TIME = 0.8f;
    for (const float part : {0.9f, 1.5f}) {
        const float acceleration = part * MU * static_cast<float>(GRAVITY);
        WorldBuilder builder = makeBuilder({}, MU);
        addBox(builder, {3, 3, 3}, {{0, 1.5f * DIAMETER, 0}});
        addMovingBox(builder, {0, -0.1f, 0}, {3, 0.1f, 0.5f}, motionOf(2, [&](float t) {
                         return Pose{{0.5f * acceleration * t * t, 0, 0}};
                     }));
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, TIME);
        const double block = std::min(1.0, 1.0 / double{part}) * acceleration * 0.5 * TIME * TIME;
        const double friction = world.bodies.empty() ? 0.0 : block;
        // The pressure of its weight builds up in some ten substeps, 0.04 s of 0.8.
        EXPECT_NEAR(solver.readBodies()[0].position.x(), friction, 0.05 * friction) << part;
    }
}

}  // namespace knuckle::test
