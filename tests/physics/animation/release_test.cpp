#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr double TIME = 0.5;  ///< When things are let go: a whole number of steps of 1/60 s [s].

Settings second()
{
    Settings settings;
    settings.velocityOrder = VelocityOrder::Second;
    return settings;
}

/// Cubes joined in a row along x, some of them held until TIME. @param fixed those held for ever.
World heldChain(uint32_t bodies, JointType type, const std::vector<uint32_t>& held, const std::vector<uint32_t>& fixed,
                const Settings& settings = second())
{
    WorldBuilder builder = makeBuilder(settings);
    beginRow(builder, bodies, type);
    for (const uint32_t b : held) builder.holdBody(b, static_cast<float>(TIME));
    for (const uint32_t b : fixed) builder.holdBody(b);
    builder.endObject();
    return builder.build();
}

/// Places and speeds, bit by bit.
void expectUnmoved(const World& world, const ParticleState& state, const std::vector<uint32_t>& bodies)
{
    for (size_t i = 0; i < world.particles.size(); ++i) {
        if (std::ranges::find(bodies, world.particles[i].body) == bodies.end()) continue;
        ASSERT_EQ(state.positions[i], world.particles[i].position) << "particle " << i;
        ASSERT_EQ(state.velocities[i], Vector3f(0, 0, 0)) << "particle " << i;
    }
}

Vector3f massCentre(const World& world, const ParticleState& state)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double mass = 0.0;
    for (size_t i = 0; i < world.particles.size(); ++i) {
        sum += world.particles[i].mass * state.positions[i].cast<double>();
        mass += world.particles[i].mass;
    }
    return (sum / mass).cast<float>();
}

class ReleasedChain : public testing::TestWithParam<JointType> {};

}  // namespace

TEST(Release, ABoxFallsFromTheMomentAtWhichItIsLetGo)
{
    WorldBuilder builder = makeBuilder(second());
    builder.holdBody(addBox(builder, {3, 3, 3}, {Vector3f(0, 5, 0)}, {3, 0, 0}, {0, 2, 0}), static_cast<float>(TIME));
    const World world = builder.build();
    Solver solver(gpu(), world);
    for (double t = 0; t < TIME - 1e-6; t += world.settings.timeStep) {
        expectUnmoved(world, solver.readParticles(), {0});
        run(solver, world, world.settings.timeStep);
    }
    run(solver, world, 1.0);
    const BodyState box = solver.readBodies()[0];
    // From rest: BDF2 after one substep of first order, which falls h^2 g/2 further and keeps h g/2 more, h = 1/480 s.
    EXPECT_NEAR(box.position.y(), 5.0 - 0.5 * GRAVITY, 0.012);
    EXPECT_NEAR(box.velocity.y(), -GRAVITY, 0.012);
    EXPECT_EQ(box.position.x(), 0.0f) << "without the velocity that it was given";
    EXPECT_LT(box.angularVelocity.norm(), 1e-6f);
}

TEST(Release, APendulumThatIsLetGoSwingsWithItsPeriod)
{
    // A cube on a hinge to a fixed one, held level until TIME.
    const World world = heldChain(2, JointType::Hinge, {1}, {0});
    Solver solver(gpu(), world);
    run(solver, world, TIME);
    expectUnmoved(world, solver.readParticles(), {0, 1});
    const Body& cube = world.bodies[1];
    const double length = reducedLength(world, 1, {2 * DIAMETER, 0, 0});
    // From rest at angle a of the vertical, T = 4 K(sin(a/2)) sqrt(I/(m g l)); K(sin 45 degrees) = 1.8540747.
    const double quarter = 1.8540747 * std::sqrt(length / GRAVITY);
    const float across = cube.restCentre.x() - 2 * DIAMETER;
    double time = 0.0, before = across;
    while (before > 0.0 && time < 2 * quarter) {
        run(solver, world, world.settings.timeStep);
        time += world.settings.timeStep;
        const double now = solver.readBodies()[1].position.x() - 2 * DIAMETER;
        if (now <= 0.0) time -= world.settings.timeStep * now / (now - before);
        before = now;
    }
    // The first substep of first order counts as half a substep of 1/480 s.
    EXPECT_NEAR(time, quarter, 0.006 * quarter);
    EXPECT_EQ(solver.readBodies()[0].position, world.bodies[0].position);
}

TEST_P(ReleasedChain, HangsFromWhatHoldsItAndFallsFreelyAfterwards)
{
    for (const std::vector<uint32_t>& held : {std::vector<uint32_t>{0}, {4}, {0, 4}, {2}, {0, 1, 2, 3, 4}}) {
        const World world = heldChain(5, GetParam(), held, {});
        SCOPED_TRACE(std::to_string(held.size()) + " held, first " + std::to_string(held[0]));
        Solver solver(gpu(), world);
        for (double t = 0; t < TIME - 1e-6; t += world.settings.timeStep) {
            run(solver, world, world.settings.timeStep);
            const ParticleState state = solver.readParticles();
            expectUnmoved(world, state, held);
            ASSERT_LT(solver.measure().worstJointGap, 0.01f * DIAMETER);
        }
        const ParticleState start = solver.readParticles();
        const Totals before = totals(world, start);
        const Vector3f from = massCentre(world, start);
        run(solver, world, 0.5);
        const ParticleState state = solver.readParticles();
        const Totals after = totals(world, state);
        double mass = 0.0;
        for (const Particle& p : world.particles) mass += p.mass;
        // Momentum gains only m g t, apart from the rounding of some 240 substeps.
        const Eigen::Vector3d gained = after.momentum - before.momentum + Eigen::Vector3d(0, mass * GRAVITY * 0.5, 0);
        EXPECT_LT(gained.norm(), 0.006 * mass * GRAVITY * 0.5) << "half a substep's fall";
        const Vector3f way = massCentre(world, state) - from - 0.5f * (before.momentum / mass).cast<float>();
        EXPECT_LT((way - Vector3f(0, static_cast<float>(-0.125 * GRAVITY), 0)).norm(), 0.01f);
        EXPECT_LT(solver.measure().worstJointGap, 0.01f * DIAMETER);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Types, ReleasedChain, testing::Values(JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal),
    [](const auto& tested) {
        return std::string(std::array{"Ball", "Hinge", "Stiff", "Universal"}[size_t(tested.param)]);
    });

TEST(Release, WhatSleepsOnAShelfFallsWithIt)
{
    Settings settings = second();
    settings.sleepSpeed = 0.02f;
    WorldBuilder builder = makeBuilder(settings);
    const uint32_t shelf = addBox(builder, {9, 1, 9}, {Vector3f(0, 3, 0)});
    addBox(builder, {3, 3, 3}, {Vector3f(0, 3 + 2 * DIAMETER, 0)});
    builder.holdBody(shelf, 3.0f);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 3.0 - 2 * world.settings.timeStep);
    EXPECT_EQ(solver.readBodies()[1].velocity.norm(), 0.0f) << "it sleeps";
    expectUnmoved(world, solver.readParticles(), {shelf});
    run(solver, world, 0.5 + 2 * world.settings.timeStep);
    for (const BodyState& body : solver.readBodies()) EXPECT_NEAR(body.velocity.y(), -0.5 * GRAVITY, 0.05);
}

TEST(Release, ABodyThatIsLetGoAtTheStartWasNeverHeld)
{
    WorldBuilder builder = makeBuilder(second());
    builder.holdBody(addBox(builder, {3, 3, 3}, {Vector3f(0, 5, 0)}), 0.0f);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    EXPECT_NEAR(solver.readBodies()[0].position.y(), 5.0 - 0.5 * GRAVITY, 0.012);
}

}  // namespace knuckle::test
