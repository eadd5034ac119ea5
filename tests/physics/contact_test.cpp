#include <algorithm>
#include <cmath>
#include <string>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// How far a block slides in 2 s, after 0.25 s, down a ramp of `degrees` with friction `mu` on both sides [m].
double slideDown(double degrees, float mu, const Settings& settings = {})
{
    WorldBuilder builder = makeBuilder(settings, mu);
    const auto slope = static_cast<float>(degrees * M_PI / 180.0);
    const Quaternionf tilt(Eigen::AngleAxisf(-slope, Vector3f::UnitZ()));
    Collider ramp = floorPlane(mu);
    ramp.orientation = tilt;
    builder.addCollider(ramp);
    addBox(builder, {5, 3, 5}, {tilt * Vector3f(0, 1.5f * DIAMETER, 0), tilt});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.25);  // the block settles
    const Vector3f start = solver.readBodies()[0].position;
    run(solver, world, 2.0);
    return (solver.readBodies()[0].position - start).norm();
}

TEST(Contact, ABlockSlidesOnARampIfAndOnlyIfItIsSteeperThanFriction)
{
    for (float mu : {0.1f, 0.3f, 0.5f, 0.7f, 1.0f}) {
        const double angle = std::atan(mu) * 180.0 / M_PI;
        // Two degrees below, it stays: less than 1 % of a diameter in 2 s. Two degrees above, it accelerates by g (sin
        // a - mu cos a) = g sin(2 deg)/cos(atan mu) >= 0.342 m/s2: 0.68 m in 2 s; the test requires a third of it.
        EXPECT_LT(slideDown(angle - 2.0, mu), 0.007 * DIAMETER) << "friction " << mu;  // measured 7e-4
        EXPECT_GT(slideDown(angle + 2.0, mu), 0.2) << "friction " << mu;
    }
}

TEST(Contact, FrictionDoesNotDependOnTheIterations)
{
    const float mu = 0.5f;
    const double repose = std::atan(mu), slope = repose + 5.0 * M_PI / 180.0;
    const double truth = 0.5 * (2.25 * 2.25 - 0.25 * 0.25) * GRAVITY * (std::sin(slope) - mu * std::cos(slope));
    for (uint32_t iterations : {1u, 2u, 10u}) {
        Settings settings;
        settings.iterations = iterations;
        // Friction lags until the block presses with its weight, in some ten substeps of 1/240 s: at most 0.04 s of
        // free sliding, g sin(a) 0.04 s = 0.2 m/s of a final speed of 2.1.
        EXPECT_NEAR(slideDown(slope * 180.0 / M_PI, mu, settings), truth, 0.1 * truth) << iterations << " iterations";
        // Measured 0.0012.
        EXPECT_LT(slideDown(repose * 180.0 / M_PI - 5.0, mu, settings), 0.01 * DIAMETER) << iterations << " iterations";
    }
}

TEST(Contact, ABlockStopsAfterItsBrakingDistance)
{
    const float mu = 0.3f, speed = 2.0f;
    const double truth = speed * speed / (2 * mu * GRAVITY);
    for (const Eigen::Vector3i& counts : {Eigen::Vector3i(3, 3, 3), Eigen::Vector3i(6, 1, 6)}) {
        WorldBuilder builder = makeBuilder({}, mu);
        builder.addCollider(floorPlane(mu));
        addBox(builder, counts, {Vector3f(0, 0.5f * DIAMETER * static_cast<float>(counts.y()), 0)}, {speed, 0, 0});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 1.5);
        // Steps of 1/240 s add up to v h / 2 less, 0.6 %; required: 5 %.
        EXPECT_NEAR(solver.readBodies()[0].position.x(), truth, 0.05 * truth) << counts.transpose();
    }
}

/// A tower of ten cubes, alternately shifted by `shift` [m].
World tower(int wide, float shift = 0.0f)
{
    WorldBuilder builder = makeBuilder();
    builder.addCollider(floorPlane());
    const float edge = DIAMETER * static_cast<float>(wide);
    for (int k = 0; k < 10; ++k)
        addBox(builder, {wide, wide, wide},
               {Vector3f(k % 2 == 0 ? 0 : shift, edge * (0.5f + static_cast<float>(k)), 0)});
    return builder.build();
}

TEST(Contact, ATowerOfTenCubesStandsForTenSecondsAndDoesNotBreathe)
{
    for (int wide : {2, 3, 4}) {
        SCOPED_TRACE(std::to_string(wide) + " particles wide");
        const World world = tower(wide);
        Solver solver(gpu(), world);
        run(solver, world, 8.0);
        double fastest = 0.0;
        for (int k = 0; k < 20; ++k) {
            run(solver, world, 0.1);
            for (const BodyState& body : solver.readBodies()) fastest = std::max(fastest, double(body.velocity.norm()));
        }
        // An undamped wave, fed by recovery, would make its top swing at half a metre a second.
        EXPECT_LT(fastest, 0.05);
        const auto bodies = solver.readBodies();
        for (size_t k = 0; k < bodies.size(); ++k) {
            const Vector3f drift = bodies[k].position - world.bodies[k].position;
            // Measured 0.041.
            EXPECT_LT(drift.norm(), 0.35f * DIAMETER) << "cube " << k << " drifted by " << drift.transpose();
        }
    }
}

TEST(Contact, ATowerOfCubesAskewStands)
{
    // If balls rested on balls, a tenth of a diameter aside, it would sway and fall over within 8 s.
    for (float shift : {0.1f, 0.3f, 0.5f}) {
        SCOPED_TRACE(std::to_string(shift) + " diameters aside");
        const World world = tower(3, shift * DIAMETER);
        Solver solver(gpu(), world);
        run(solver, world, 10.0);
        const auto bodies = solver.readBodies();
        for (size_t k = 0; k < bodies.size(); ++k) {
            const Vector3f moved = bodies[k].position - world.bodies[k].position;
            EXPECT_LT(moved.norm(), 0.1f * DIAMETER) << "cube " << k;
        }
    }
}

/// A block on a fixed one of 4 m, both of particles, which slopes by `degrees`, falling towards -x.
World blockOnABlock(double degrees, double yaw, float mu, const Vector3f& velocity)
{
    WorldBuilder builder = makeBuilder({}, mu);
    const Quaternionf tilt(Eigen::AngleAxisf(static_cast<float>(degrees * M_PI / 180.0), Vector3f::UnitZ()));
    const Quaternionf turn(Eigen::AngleAxisf(static_cast<float>(yaw * M_PI / 180.0), Vector3f::UnitY()));
    builder.beginObject("ramp");
    builder.addBody("ramp", boxLattice({40, 2, 10}, DIAMETER), 0, Motion::Fixed);
    builder.endObject({Vector3f(0, 0, 0), tilt});
    addBox(builder, {4, 3, 4}, {tilt * Vector3f(0.23f, 2.5f * DIAMETER, 0.04f), tilt * turn}, velocity);
    return builder.build();
}

TEST(Contact, ABlockSlidesOnABlockOfParticlesAsOnAPlane)
{
    const float mu = 0.3f, speed = 1.5f;
    const double braking = speed * speed / (2 * mu * GRAVITY);
    for (double yaw : {0.0, 30.0}) {
        SCOPED_TRACE("turned by " + std::to_string(yaw));
        {
            const World world = blockOnABlock(0, yaw, mu, {-speed, 0, 0});
            Solver solver(gpu(), world);
            run(solver, world, 1.0);
            // Steps of 1/240 s add up to v h / 2 less, 0.8 %; required: 5 %; bumps would leave less than half.
            const Vector3f moved = solver.readBodies()[1].position - world.bodies[1].position;
            EXPECT_NEAR(moved.norm(), braking, 0.05 * braking);
            EXPECT_LT(std::abs(moved.y()), 0.01f * DIAMETER);  // measured 0.0013
        }
        for (double degrees : {10.0, 25.0}) {
            const World world = blockOnABlock(degrees, yaw, mu, {0, 0, 0});
            Solver solver(gpu(), world);
            run(solver, world, 0.75);
            const double a = degrees * M_PI / 180.0, pull = GRAVITY * (std::sin(a) - mu * std::cos(a));
            // As on a plane, friction lags until the block presses with its weight: at most 0.01 s of free sliding.
            const double lag = GRAVITY * std::sin(a) * 0.01 * 0.75, moved = 0.5 * std::max(pull, 0.0) * 0.75 * 0.75;
            const Vector3f found = solver.readBodies()[1].position - world.bodies[1].position;
            EXPECT_NEAR(found.norm(), moved, lag) << degrees << " degrees";
        }
    }
}

TEST(Contact, ABlockAtRestNeitherSinksNorMoves)
{
    WorldBuilder builder = makeBuilder();
    builder.addCollider(floorPlane());
    addBox(builder, {3, 3, 3}, {Vector3f(0, 1.5f * DIAMETER, 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    const Vector3f first = solver.readBodies()[0].position;
    run(solver, world, 2.0);
    EXPECT_LT((solver.readBodies()[0].position - first).norm(), 1e-3 * DIAMETER);
    EXPECT_LT(solver.measure().worstPenetration, 0.006f * DIAMETER);  // measured 7e-4
}

TEST(Contact, TwoCubesThatCollideKeepTheirMomentum)
{
    WorldBuilder builder = makeBuilder(weightless());
    addBox(builder, {3, 3, 3}, {Vector3f(-0.5f, 0.03f, 0.02f)}, {1, 0, 0});
    addBox(builder, {3, 3, 3}, {Vector3f(0.5f, 0, 0)}, {-0.5f, 0, 0});
    const World world = builder.build();
    Solver solver(gpu(), world);
    const Totals before = totals(world, solver.readParticles());
    run(solver, world, 2.0);
    const Totals after = totals(world, solver.readParticles());
    // Both sides of a contact compute the same impulse, so only rounding is left.
    EXPECT_LT((after.momentum - before.momentum).norm(), 3e-7 * before.speedSum);  // measured 4e-8
}

TEST(Contact, AFastCubeDoesNotPassThroughTheFloor)
{
    WorldBuilder builder = makeBuilder();
    builder.addCollider(floorPlane());
    addBox(builder, {3, 3, 3}, {Vector3f(0, 1, 0)}, {0, -20, 0}, {3, 5, 1});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    EXPECT_GT(lowestBody(solver.readBodies()), 0.5f * DIAMETER);
}

}  // namespace knuckle::test
