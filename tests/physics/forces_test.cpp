#include <cmath>
#include <numbers>

#include "shared/force_types.h"
#include "sim/base/errors.h"
#include "sim/world/builder/parts/cloth.h"
#include "tests/message_of.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float AIR = 40.0f;  // so dense that everything soon reaches its final speed [kg/m3]

/// The speed of a fall after a time, from rest: v tanh(g t / v) with the final speed v of m g = drag v^2.
/// @param dragArea drag coefficient times area [m2].
double fallSpeed(double mass, double dragArea, double seconds)
{
    const double last = std::sqrt(2.0 * mass * GRAVITY / (AIR * dragArea));
    return last * std::tanh(GRAVITY * seconds / last);
}

/// An implicit substep has m g = drag v^2 / (1 + h rate), finally rate = g / v: v is higher by half of h g, where h is
/// 1/240 s. Before that the step adds at most as much.
double tolerance(double speed)
{
    return GRAVITY / 240.0 + 2e-3 * speed;
}

WorldBuilder inStillAir(const Settings& settings = {})
{
    WorldBuilder builder = makeBuilder(settings);
    builder.setWind({.density = AIR});
    return builder;
}

TEST(Forces, ABlockFallsAsFastAsItsAreaAcrossTheWayLetsIt)
{
    WorldBuilder builder = inStillAir();
    const Quaternionf upright(Eigen::AngleAxisf(std::numbers::pi_v<float> / 2, Vector3f::UnitZ()));
    addBox(builder, {6, 2, 2});
    addBox(builder, {6, 2, 2}, {{3, 0, 0}, upright});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 4.0);
    const double mass = 24 * 1000 * std::pow(DIAMETER, 3), face = BLOCK_DRAG * DIAMETER * DIAMETER;
    const double flat = fallSpeed(mass, 12 * face, 4.0), onEnd = fallSpeed(mass, 4 * face, 4.0);
    EXPECT_NEAR(-solver.readBodies()[0].velocity.y(), flat, tolerance(flat));
    EXPECT_NEAR(-solver.readBodies()[1].velocity.y(), onEnd, tolerance(onEnd));
}

TEST(Forces, ABallAGrainAndADropFallAsSpheresDo)
{
    WorldBuilder builder = inStillAir();
    const float radius = 0.25f;
    builder.beginObject("ball");
    builder.addBody("ball", sphereLattice(radius, DIAMETER), 0, Motion::Dynamic, {}, {radius, 0.0f});
    builder.endObject();
    Particle grain;
    grain.position = {3, 0, 0};
    grain.mass = builder.particleMass(0);
    builder.addLooseParticle(grain);
    Material water;
    water.fluid = true;
    const Vector3f place(6, 0, 0);
    builder.addFluid(std::span(&place, 1), {0, 0, 0}, builder.addMaterial(water));
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 4.0);
    const double pi = std::numbers::pi;
    // In a world with fluids a ball weighs as much as its particles.
    const double ball = fallSpeed(world.bodies[0].mass, SPHERE_DRAG * pi * radius * radius, 4.0);
    EXPECT_NEAR(-solver.readBodies()[0].velocity.y(), ball, tolerance(ball));
    const ParticleState state = solver.readParticles();
    const size_t drop = state.velocities.size() - 1;
    const double ofGrain = fallSpeed(world.particles[drop - 1].mass, SPHERE_DRAG * pi * 0.25 * DIAMETER * DIAMETER,
                                     4.0);
    EXPECT_NEAR(-state.velocities[drop - 1].y(), ofGrain, tolerance(ofGrain));
    const double spacing = world.fluidSpacing, wide = spacing * std::cbrt(0.75 / pi);
    const double ofDrop = fallSpeed(1000 * std::pow(spacing, 3), SPHERE_DRAG * pi * wide * wide, 4.0);
    EXPECT_NEAR(-state.velocities[drop].y(), ofDrop, tolerance(ofDrop));
}

TEST(Forces, AClothThatLiesInTheAirFallsAsAPlate)
{
    WorldBuilder builder = inStillAir();
    const ClothSpec spec;
    addCloth(builder, "cloth", gridSheet(1.0f, 0.8f, DIAMETER, spec), spec, {}, {});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.75);  // later it tips over, as sheets do
    // Mass and area of each node are proportional, so all fall alike, except those at corners, of which one has two
    // triangles and one has one; the cloth passes their deficit on.
    double mass = 0.0, momentum = 0.0;
    const ParticleState state = solver.readParticles();
    for (size_t i = 0; i < world.particles.size(); ++i) {
        mass += world.particles[i].mass;
        momentum -= world.particles[i].mass * state.velocities[i].y();
    }
    const double plate = fallSpeed(mass, PLATE_DRAG * 0.8, 0.75);
    EXPECT_NEAR(momentum / mass, plate, tolerance(plate));
}

TEST(Forces, SteadyWindTakesThingsAlongAndNoFaster)
{
    WorldBuilder builder = makeBuilder(weightless());
    builder.setWind({.velocity = {4, 0, -3}, .density = AIR, .gusts = 0.0f});
    addBox(builder, {2, 2, 2});
    const World world = builder.build();
    Solver solver(gpu(), world);
    const double drag = 0.5 * AIR * BLOCK_DRAG * 4 * DIAMETER * DIAMETER / (8 * 1000 * std::pow(DIAMETER, 3));
    double seconds = 0.0;
    for (int step = 0; step < 120; ++step) {
        run(solver, world, world.settings.timeStep);
        seconds += world.settings.timeStep;
        // With the lag w behind the wind, dw/dt = -drag w |w_axes|: along one direction, w = 5 / (1 + 5 drag t). An
        // implicit substep lags by at most the fraction h drag 5 / 2.
        const double behind = 5.0 / (1.0 + 5.0 * drag * seconds);
        const Vector3f velocity = solver.readBodies()[0].velocity;
        EXPECT_NEAR((Vector3f(4, 0, -3) - velocity).norm(), behind, 0.01 * 5.0) << seconds;
    }
}

TEST(Forces, APullByTheInverseSquareHoldsAnOrbit)
{
    WorldBuilder builder = makeBuilder(weightless());
    ForceField field{.kind = FieldKind::Pull, .falloff = FieldFalloff::InverseSquare, .region = {}, .strength = 4.0f};
    field.region.shape = ColliderShape::Sphere;
    field.region.position = {1, 2, 3};
    field.region.radius = 10.0f;
    builder.addForceField(field);
    Particle particle;
    particle.position = Vector3f(1, 2, 3) + Vector3f(1, 0, 0);
    particle.velocity = {0, 0, 2};  // v^2 / r = 4 / r^2 at 1 m
    builder.addLooseParticle(particle);
    const World world = builder.build();
    Solver solver(gpu(), world);
    double farthest = 0.0;
    for (int step = 0; step < 188; ++step) {  // one round takes pi seconds, 188.5 steps
        run(solver, world, world.settings.timeStep);
        const Vector3f from = solver.readParticles().positions[0] - field.region.position;
        farthest = std::max(farthest, std::abs(double{from.norm()} - 1.0));
    }
    const Vector3f end = solver.readParticles().positions[0] - field.region.position;
    // Second order: off by the square of h v / r, 1/120, times the way of 2 pi; the first substep, of first order, by
    // 1/120 of 1/120. And 188 steps end half a step, 1/60, before the round does.
    EXPECT_LT(farthest, 2e-3);
    EXPECT_LT((end - Vector3f(1, 0, 0)).norm(), 0.02);
}

TEST(Forces, APushActsInItsRegionAndItsTimeOnEverythingAlike)
{
    WorldBuilder builder = makeBuilder(weightless());
    ForceField field{.kind = FieldKind::Push, .falloff = FieldFalloff::None, .region = {}, .strength = 100.0f};
    field.region.shape = ColliderShape::Sphere;
    field.region.radius = 2.0f;
    field.start = 0.5f;
    field.stop = 0.6f;
    builder.addForceField(field);
    Material lead;
    lead.density = 11000.0f;
    const uint32_t heavy = builder.addMaterial(lead);
    Particle particle;
    for (const auto& [place, material] :
         {std::pair{Vector3f(0, 1, 0), 0u}, std::pair{Vector3f(0, -1, 0), heavy}, std::pair{Vector3f(3, 0, 0), 0u}}) {
        particle.position = place;
        particle.mass = builder.particleMass(material);
        particle.material = material;
        builder.addLooseParticle(particle);
    }
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.5 - 0.5 * world.settings.timeStep);
    for (const Vector3f& v : solver.readParticles().velocities) EXPECT_EQ(v, Vector3f(0, 0, 0));
    run(solver, world, 0.5);
    const std::vector<Vector3f> velocities = solver.readParticles().velocities;
    // A tenth of a second is 24 substeps, plus or minus one depending on where they begin.
    EXPECT_NEAR(velocities[0].y(), 10.0, 10.0 / 24);
    EXPECT_NEAR(velocities[1].y(), -velocities[0].y(), 1e-3);
    EXPECT_EQ(velocities[2], Vector3f(0, 0, 0)) << "outside";
}

TEST(Forces, GustsHaveTheStrengthThatIsSaidAndNoMean)
{
    const Wind wind{.velocity = {6, 0, 0}, .gusts = 0.4f, .gustSize = 0.5f, .seed = 7};
    const std::vector<GustWave> waves = gustWaves(wind);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double squares = 0.0;
    int count = 0;
    for (int k = 0; k < 40000; ++k, ++count) {
        const auto at = [&](double step) { return static_cast<float>(std::fmod(k * step, 97.0)); };
        const Vector3f gust = airVelocity(wind, waves, {at(0.618), at(0.755), at(0.569)}, at(0.324)) -
                              Vector3f(6, 0, 0);
        sum += gust.cast<double>();
        squares += gust.squaredNorm();
    }
    // 16 waves sampled 40000 times without a common period: means are accurate to a few hundredths.
    EXPECT_NEAR(std::sqrt(squares / count), 0.4 * 6, 0.05 * 0.4 * 6);
    EXPECT_LT(sum.norm() / count, 0.03 * 0.4 * 6);
    for (const GustWave& wave : waves) EXPECT_LT(std::abs(wave.wave.dot(wave.amplitude)), 1e-4f * wave.wave.norm());
    EXPECT_NE(gustWaves({.velocity = {6, 0, 0}, .seed = 8})[0].phase, waves[0].phase);
}

TEST(Forces, WhatRestsForEverDoesNotGoWithThem)
{
    Settings settings;
    settings.sleepSpeed = 0.05f;
    WorldBuilder builder = inStillAir(settings);
    addBox(builder, {2, 2, 2});
    EXPECT_EQ(messageOf<InputError>([&] { builder.build(); }),
              "wind and fields may move what rests; set /solver/sleep and /solver/freeze to 0");
}

}  // namespace

}  // namespace knuckle::test
