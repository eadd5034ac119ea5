#include <cmath>

#include "tests/physics/animation/moving_fixture.h"
#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

constexpr float HALF = 1.5f * DIAMETER;  // of a cube of three particles [m]

/// A cube at rest in the way of a piston, on a floor or weightless. @param after time since they meet [s].
/// @returns the cube's speed then [m/s], and its face's distance from the piston's [m].
std::pair<float, float> struckBy(float speed, float restitution, bool onFloor, double after)
{
    WorldBuilder builder(DIAMETER / 2, onFloor ? Settings() : weightless());
    Material material;
    material.restitution = restitution;
    builder.addMaterial(material);
    addBox(builder, {3, 3, 3}, {{0, HALF, 0}});
    if (onFloor) builder.addCollider(floorPlane());
    addMovingBox(builder, {-0.6f, HALF, 0}, {0.2f, 0.5f, 0.4f}, straightMotion({speed, 0, 0}, 2));
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.25 / double{speed} + after);  // they meet after 0.25 m
    const BodyState cube = solver.readBodies()[0];
    EXPECT_LT(cube.angularVelocity.norm(), 0.02f * speed);
    return {cube.velocity.x(), cube.position.x() - HALF - (solver.readColliders().back().position.x() + 0.2f)};
}

/// A cube that turns with a table about y from the start. @param share of the speed at which friction just holds it.
/// @returns its distance from the axis two seconds later [m].
float distanceOnTable(float share)
{
    constexpr float RADIUS = 0.6f, MU = 0.5f;
    const float spin = share * std::sqrt(MU * static_cast<float>(GRAVITY) / RADIUS);
    WorldBuilder builder = makeBuilder({}, MU);
    addBox(builder, {2, 2, 2}, {{RADIUS, DIAMETER, 0}}, {0, 0, -spin * RADIUS}, {0, spin, 0});
    addMovingBox(builder, {0, -0.2f, 0}, {3, 0.2f, 3}, motionOf(4, [&](float t) {
                     return Pose{{0, 0, 0}, Quaternionf(Eigen::AngleAxisf(spin * t, Vector3f::UnitY()))};
                 }));
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    const Vector3f place = solver.readBodies()[0].position;
    return std::hypot(place.x(), place.z());
}

}  // namespace

/// Nothing stops a piston, so a body at rest gets (1 + e) times its speed, and parts from it at e v.
TEST(MovingCollider, APistonGivesWhatBouncesOffItsSpeedAndWhatTheBounceAdds)
{
    // Seven rounds of restitution leave a hundredth of their change (Restitution.TwoThatCollide...).
    for (const float speed : {0.5f, 2.0f}) {
        const float after = struckBy(speed, 0.8f, false, 0.2).first;
        EXPECT_NEAR(after, 1.8f * speed, 0.02f * 1.8f * speed) << speed << " m/s";
    }
}

/// It pushes along a body with a restitution of 0. A blow leaves up to a tenth more speed than that, as a wall does,
/// which friction takes in 0.1 v / (mu g), 0.2 s at 10 m/s; it takes as long again until they meet again. 10 m/s are
/// 0.42 diameters in a substep, more than the margin of the search for contacts.
TEST(MovingCollider, APistonPushesAlongWhatItMeetsHoweverFastItIs)
{
    for (const float speed : {0.5f, 2.0f, 10.0f}) {
        const auto [after, gap] = struckBy(speed, 0, true, 0.6);
        EXPECT_NEAR(after, speed, 0.02f * speed) << speed << " m/s";
        EXPECT_NEAR(gap, 0, 0.05f * DIAMETER) << speed << " m/s";
    }
}

/// Up from rest at 3 m/s2, and down again at less than gravity: the cube stays on it.
TEST(MovingCollider, ALiftCarriesWhatStandsOnIt)
{
    for (const float acceleration : {3.0f, -5.0f}) {
        WorldBuilder builder = makeBuilder();
        addBox(builder, {3, 3, 3}, {{0, HALF, 0}});
        addMovingBox(builder, {0, -0.1f, 0}, {0.5f, 0.1f, 0.5f}, motionOf(1, [&](float t) {
                         return Pose{{0, 0.5f * acceleration * t * t, 0}};
                     }));
        const World world = builder.build();
        Solver solver(gpu(), world);
        for (int step = 1; step <= 60; ++step) {
            run(solver, world, world.settings.timeStep);
            const BodyState cube = solver.readBodies()[0];
            const float t = static_cast<float>(step) * world.settings.timeStep;
            // It sinks in under its weight, and lags by the last acceleration's way in a substep.
            ASSERT_NEAR(cube.position.y() - HALF, 0.5f * acceleration * t * t, 0.02f * DIAMETER) << "at " << t;
        }
        // The speed of the last substep, whose middle is 1/480 s ago.
        EXPECT_NEAR(solver.readBodies()[0].velocity.y(), acceleration, 0.02f * std::abs(acceleration));
    }
}

/// A table takes a body along while w^2 r < mu g.
TEST(MovingCollider, ATurningTableCarriesWhatFrictionHoldsAndLosesTheRest)
{
    // Ten per cent below and above: w^2 r is 0.81 and 1.21 of mu g. A sliding cube moves outwards by at least the
    // excess, 0.21 mu g, for 2 s: metres.
    EXPECT_NEAR(distanceOnTable(0.9f), 0.6f, 0.01f);
    EXPECT_GT(distanceOnTable(1.1f), 1.0f);
}

/// A ball on a belt at 1 m/s that rolls without slipping: friction spins it up until its lowest point moves with the
/// belt. The centre of a solid ball with I = 2/5 m r^2 then has 2/7 of the belt's speed.
TEST(MovingCollider, ABallOnABeltIsLeftWithTwoSeventhsOfItsSpeed)
{
    WorldBuilder builder = makeBuilder();
    const RoundShape round{0.2f, 0.0f};
    const std::vector<Vector3f> places = sphereLattice(round.radius, DIAMETER);
    std::vector<SurfaceDistance> surface;
    for (const Vector3f& p : places) surface.push_back(capsuleSurface(p, round.radius, 0));
    builder.beginObject("ball");
    builder.addBody("ball", places, 0, Motion::Dynamic, surface, round);
    builder.endObject({{0, round.radius, 0}});
    addMovingBox(builder, {0, -0.1f, 0}, {4, 0.1f, 1}, straightMotion({1, 0, 0}, 2));
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    const BodyState ball = solver.readBodies()[0];
    // Its inertia is that of its particles, within a tenth of a solid ball's: 5 % of the speed.
    EXPECT_NEAR(ball.velocity.x(), 2.0f / 7.0f, 0.05f * 2.0f / 7.0f);
    EXPECT_NEAR(ball.velocity.x() - (-ball.angularVelocity.z() * round.radius), 1.0f, 0.02f);
}

/// A wall of a tank moves in by a quarter of its width: the water rises to its height in a tank of this width, and none
/// is behind the wall.
TEST(MovingCollider, AWallThatMovesInRaisesTheWater)
{
    Tank tank(16, 9, 8);
    Collider wall;
    wall.position = {tank.width, 0, 0};
    wall.orientation = Quaternionf::FromTwoVectors(Vector3f::UnitY(), -Vector3f::UnitX());
    tank.builder.addCollider(wall);
    const float way = 0.25f * tank.width;
    // Along its normal, -x, which is its own y.
    BodyClip clip = motionOf(2, [&](float t) { return Pose{{0, way * t * t * (3 - t) / 4, 0}}; });
    tank.builder.moveColliders(1, {wall.position, wall.orientation},
                               {.clip = tank.builder.addClip(std::move(clip)), .loop = false});
    Tank narrow(12, 12, 8);
    const uint32_t water = tank.fluids[0];
    const World world = tank.builder.build(), other = narrow.builder.build();
    ASSERT_EQ(world.fluidCount, other.fluidCount);
    Solver solver(gpu(), world), reference(gpu(), other);
    run(solver, world, 4.0);
    run(reference, other, 2.0);
    const ParticleState state = solver.readParticles();
    const double wanted = meanHeight(other, reference.readParticles(), water);
    EXPECT_NEAR(meanHeight(world, state, water), wanted, 0.01 * wanted);
    for (const Vector3f& place : state.positions) ASSERT_LT(place.x(), tank.width - way + 0.01f * DIAMETER);
    EXPECT_LT(rootMeanSquareSpeed(state), 0.1);
}

}  // namespace knuckle::test
