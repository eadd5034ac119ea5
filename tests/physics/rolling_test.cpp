#include <cmath>
#include <string>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// A ball (halfHeight 0) or a capsule that lies along z, in units of diameters; its lowest point at the origin.
void addRound(WorldBuilder& builder, float radius, float halfHeight, const Vector3f& velocity = {0, 0, 0},
              const Vector3f& spin = {0, 0, 0})
{
    const RoundShape round{radius * DIAMETER, halfHeight * DIAMETER};
    const std::vector<Vector3f> places = halfHeight > 0 ? capsuleLattice(round.radius, round.halfHeight, DIAMETER)
                                                        : sphereLattice(round.radius, DIAMETER);
    std::vector<SurfaceDistance> surface;
    for (const Vector3f& place : places) surface.push_back(capsuleSurface(place, round.radius, round.halfHeight));
    builder.beginObject("round");
    builder.addBody("round", places, 0, Motion::Dynamic, surface, round);
    const Quaternionf lying(Eigen::AngleAxisf(static_cast<float>(M_PI / 2), Vector3f::UnitX()));
    builder.endObject({Vector3f(0, round.radius, 0), lying}, velocity, spin);
}

/// Gravity as on a slope of `degrees` that falls towards +x.
Settings slope(double degrees)
{
    Settings settings;
    const double a = degrees * M_PI / 180.0;
    settings.gravity = Vector3f(static_cast<float>(GRAVITY * std::sin(a)), static_cast<float>(-GRAVITY * std::cos(a)),
                                0);
    return settings;
}

/// The distance that it rolls from rest [m].
double rollDown(double degrees, float radius, float halfHeight, double seconds, float rolling = 0.0f,
                bool onParticles = false)
{
    WorldBuilder builder(DIAMETER / 2, slope(degrees));
    Material material;
    material.name = "test";
    material.rollingFriction = rolling;
    builder.addMaterial(material);
    if (!onParticles) builder.addCollider(floorPlane());
    addRound(builder, radius, halfHeight);
    if (onParticles) {
        builder.beginObject("floor");
        builder.addBody("floor", boxLattice({50, 2, 10}, DIAMETER), 0, Motion::Fixed);
        builder.endObject({Vector3f(15 * DIAMETER, -DIAMETER, 0.03f)});
    }
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, seconds);
    return solver.readBodies()[0].position.x();
}

/// I / (M R^2) of a capsule about its axis: a cylinder of 2 h and a ball.
double inertiaOf(double radius, double halfHeight)
{
    const double middle = 2 * halfHeight, caps = 4.0 / 3.0 * radius;
    return (0.5 * middle + 0.4 * caps) / (middle + caps);
}

TEST(Rolling, BallsAndCapsulesRollDownASlopeAsSolidOnesDo)
{
    // Required: 2 %. The pressure of their weight takes some ten substeps to build up, in which friction lags.
    for (float radius : {1.5f, 2.0f, 3.0f, 4.3f})
        for (float half : {0.0f, 2.5f}) {
            SCOPED_TRACE(std::to_string(radius) + " diameters, half height " + std::to_string(half));
            const double seconds = 1.5, truth = 0.5 * GRAVITY * std::sin(10 * M_PI / 180) * seconds * seconds /
                                                (1 + inertiaOf(radius, half));
            EXPECT_NEAR(rollDown(10, radius, half, seconds), truth, 0.02 * truth);  // measured 0.0027
        }
}

TEST(Rolling, OnABlockOfParticlesTheyRollAsOnAPlane)
{
    // Every change of the touching particles makes friction forget: they slip a little.
    const double seconds = 1.2;
    for (float half : {0.0f, 1.5f}) {
        const double truth = 0.5 * GRAVITY * std::sin(10 * M_PI / 180) * seconds * seconds / (1 + inertiaOf(3, half));
        EXPECT_NEAR(rollDown(10, 3, half, seconds, 0, true), truth, 0.05 * truth) << half;  // measured 0.028, 0.029
    }
}

TEST(Rolling, OnTheLevelABallRollsOn)
{
    for (float radius : {2.0f, 4.0f}) {
        WorldBuilder builder = makeBuilder();
        builder.addCollider(floorPlane());
        addRound(builder, radius, 0, {2, 0, 0}, {0, 0, -2 / (radius * DIAMETER)});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 3.0);
        // Nothing slows it down, and nothing must speed it up.
        EXPECT_NEAR(solver.readBodies()[0].velocity.x(), 2.0, 0.01) << radius;
        EXPECT_NEAR(solver.readBodies()[0].position.x(), 6.0, 0.025) << radius;  // measured 0.003
    }
}

TEST(Rolling, RollingFrictionHoldsAndBrakes)
{
    // The tangent of 5 degrees is 0.087, below 0.1: it lies still. That of 10 degrees is above: the rest of the pull
    // accelerates it. Required: 1.6 %, and a tenth of a diameter.
    EXPECT_LT(std::abs(rollDown(5, 3, 0, 2.0, 0.1f)), 0.1 * DIAMETER);
    const double a = 10 * M_PI / 180, truth = 0.5 * GRAVITY * (std::sin(a) - 0.1 * std::cos(a)) * 4.0 / 1.4;
    EXPECT_NEAR(rollDown(10, 3, 0, 2.0, 0.1f), truth, 0.016 * truth);  // measured 0.002
}

TEST(Rolling, BodiesOfKnownVolumeWeighDensityTimesVolume)
{
    WorldBuilder builder = makeBuilder();
    addRound(builder, 2, 0);
    addRound(builder, 1.5f, 3);
    addBox(builder, {2, 3, 4});
    const World world = builder.build();
    const double d = DIAMETER, unit = 1000 * d * d * d;
    EXPECT_NEAR(world.bodies[0].mass, unit * 4.0 / 3.0 * M_PI * 8, 5e-6 * unit);                 // measured 6e-7
    EXPECT_NEAR(world.bodies[1].mass, unit * M_PI * 2.25 * (4.0 / 3.0 * 1.5 + 6), 4e-5 * unit);  // measured 5e-6
    EXPECT_NEAR(world.bodies[2].mass, unit * 24, 1e-5 * unit);                                   // measured 1.1e-6
}

/// The turn of a post of 2 x 5 x 2 in 2 s, with `pull` of its weight along x [rad].
double tip(double pull)
{
    Settings settings;
    settings.gravity = Vector3f(static_cast<float>(pull * GRAVITY), static_cast<float>(-GRAVITY), 0);
    WorldBuilder builder = makeBuilder(settings, 2.0f);
    builder.addCollider(floorPlane(2.0f));
    addBox(builder, {2, 5, 2}, {Vector3f(0, 2.5f * DIAMETER, 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    return solver.readBodies()[0].rotation.angularDistance(Quaternionf::Identity());
}

TEST(Rolling, APostTipsWhereItsEdgeSays)
{
    // Width over height: 0.4. Required: 5 %.
    EXPECT_LT(tip(0.38), 2e-3);  // measured 3e-4
    EXPECT_GT(tip(0.42), 0.5);
}

TEST(Rolling, WhatRestsBelowTheFrictionAngleDoesNotCreep)
{
    // arctan 0.5 is 26.6 degrees. Required: less than 1 % of a diameter in 20 s, after it has settled.
    for (bool onParticles : {false, true}) {
        WorldBuilder builder(DIAMETER / 2, slope(24));
        Material material;
        material.name = "test";
        builder.addMaterial(material);
        builder.addCollider(floorPlane());
        if (onParticles) {
            builder.beginObject("floor");
            builder.addBody("floor", boxLattice({10, 2, 10}, DIAMETER), 0, Motion::Fixed);
            builder.endObject({Vector3f(0, DIAMETER, 0)});
        }
        const uint32_t body = addBox(builder, {4, 3, 4},
                                     {Vector3f(0.03f, (onParticles ? 3.5f : 1.5f) * DIAMETER, 0.02f)});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 0.5);
        const Vector3f start = solver.readBodies()[body].position;
        run(solver, world, 20.0);
        // Measured 9e-4.
        EXPECT_LT((solver.readBodies()[body].position - start).norm(), 0.007f * DIAMETER) << onParticles;
    }
}

TEST(Rolling, ABlockThatRestsSlidesOnlyBeyondItsStaticFriction)
{
    // 22.5 degrees: the tangent 0.414 is below the static 0.6 and above the kinetic 0.2.
    WorldBuilder builder(DIAMETER / 2, slope(22.5));
    Material material;
    material.name = "test";
    material.staticFriction = 0.6f;
    material.kineticFriction = 0.2f;
    builder.addMaterial(material);
    Collider plane = floorPlane(0.6f);
    plane.kineticFriction = 0.2f;
    builder.addCollider(plane);
    addBox(builder, {4, 3, 4}, {Vector3f(0, 1.5f * DIAMETER, 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 3.0);
    EXPECT_LT(solver.readBodies()[0].position.x(), 0.008f * DIAMETER);  // measured 9e-4
}

}  // namespace knuckle::test
