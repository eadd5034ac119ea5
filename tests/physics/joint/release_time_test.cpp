#include <cmath>

#include "sim/world/builder/parts/rope.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float TIME = 0.5f;

/// A cube beside a ball joint of the world that lets go, at rest a metre from it along x.
World heldCube(const Settings& settings, float time, const Vector3f& place)
{
    WorldBuilder builder = makeBuilder(settings);
    const uint32_t cube = addBox(builder, {3, 3, 3}, {place});
    JointSpec spec;
    spec.name = "grip";
    spec.strength.time = time;
    builder.joinPlaced(NO_INDEX, cube, spec);
    return builder.build();
}

/// Steps on from a moment at which a body was let go, and expects it on its parabola for half a second.
void expectParabola(Solver& solver, const World& world, uint32_t body)
{
    const double step = world.settings.timeStep, h = step / world.settings.substeps;
    const BodyState start = solver.readBodies()[body];
    for (int k = 1; k <= 30; ++k) {
        run(solver, world, step);
        const double t = k * step;
        const Vector3f way = solver.readBodies()[body].position - start.position;
        // Second order goes on from the last two moves, in which it was held: by its pull, of 3 g at the lowest, for up
        // to a substep.
        EXPECT_NEAR(way.x(), start.velocity.x() * t, 3 * GRAVITY * h * t + 1e-3);
        EXPECT_NEAR(way.y(), start.velocity.y() * t - 0.5 * GRAVITY * t * t, 3 * GRAVITY * h * t + 1e-3);
    }
}

}  // namespace

TEST(ReleaseTime, AJointHoldsUntilThenAndItsBobFliesAParabola)
{
    const World world = heldCube({}, TIME, {1, 0, 0});
    Solver solver(gpu(), world);
    for (int k = 0; k < 30; ++k) {
        run(solver, world, world.settings.timeStep);
        ASSERT_NEAR(solver.readBodies()[0].position.norm(), 1.0, 1e-3) << "frame " << k;
    }
    EXPECT_GT(solver.readBodies()[0].velocity.norm(), 3.0f);
    expectParabola(solver, world, 0);
}

TEST(ReleaseTime, WhatItHeldTogetherKeepsItsMomentum)
{
    WorldBuilder builder = makeBuilder(weightless());
    PairSpec pair;
    pair.joint.strength.time = TIME;
    addJointedPair(builder, pair, {}, {0.3f, 0, 0}, {0, 0, 5});
    const World world = builder.build();
    Solver solver(gpu(), world);
    const auto apart = [&] {
        const std::vector<BodyState> bodies = solver.readBodies();
        return double((bodies[0].position - bodies[1].position).norm());
    };
    const double before = apart();
    run(solver, world, TIME);
    EXPECT_NEAR(apart(), before, 1e-3);
    // Of bodies: the particle that both share stays with one, and what it weighs in the other with that.
    const auto momentum = [&] {
        Vector3f sum = Vector3f::Zero();
        const std::vector<BodyState> bodies = solver.readBodies();
        for (size_t b = 0; b < bodies.size(); ++b) sum += world.bodies[b].mass * bodies[b].velocity;
        return sum;
    };
    const Vector3f held = momentum();
    run(solver, world, TIME);
    // Each flies on with the speed of its circle of radius r = before / 2: by Pythagoras.
    EXPECT_NEAR(apart(), before * std::hypot(1.0, 5 * double{TIME}), 0.02 * before);
    EXPECT_LT((momentum() - held).norm(), 1e-3f * held.norm());
}

TEST(ReleaseTime, WakesWhatSleeps)
{
    Settings settings;
    settings.sleepSpeed = 0.05f;
    const World world = heldCube(settings, 2.0f, {0, -0.5f, 0});
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    EXPECT_NEAR(solver.readBodies()[0].position.y(), -0.5f, 1e-3f);
    expectParabola(solver, world, 0);
}

TEST(ReleaseTime, ARopeLetsGoOfItsEnd)
{
    for (const bool limp : {true, false}) {
        WorldBuilder builder = makeBuilder();
        const uint32_t cube = addBox(builder, {3, 3, 3}, {{1.1f, 0, 0}});
        RopeSpec rope;
        rope.from = {0, 0, 0};
        rope.to = {1, 0, 0};
        rope.start.kind = RopeEnd::Kind::Fixed;
        rope.end = {RopeEnd::Kind::Attached, particleAt(builder, rope.to), TIME};
        if (!limp) rope.bendCompliance = 1e-3f;
        addRope(builder, "rope", rope);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, TIME);
        const uint32_t last = world.strands[0].particles.back();
        EXPECT_NEAR(solver.readParticles().positions[last].norm(), 1.0, 5e-3);
        expectParabola(solver, world, cube);
    }
}

}  // namespace knuckle::test
