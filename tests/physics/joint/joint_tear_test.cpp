#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/physics/joint/chain_fixture.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// Mass of the bodies from one on [kg].
float massFrom(const World& world, uint32_t body)
{
    float mass = 0;
    for (uint32_t b = body; b < world.bodies.size(); ++b) mass += world.bodies[b].mass;
    return mass;
}

TEST(JointTear, AChainTearsWhereItBearsMoreThanItCan)
{
    ChainSpec spec{.bodies = 5};
    const float weight = static_cast<float>(GRAVITY) * massFrom(chain(spec), 1);
    spec.strength.force = 1.005f * weight;
    const World strong = chain(spec);
    Solver holds(gpu(), strong);
    run(holds, strong, 1.0);
    EXPECT_NEAR(holds.readBodies()[4].position.y(), strong.bodies[4].position.y(), 1e-6f);  // measured 1.2e-7

    spec.strength.force = 0.995f * weight;
    const World weak = chain(spec);
    Solver tears(gpu(), weak);
    run(tears, weak, 0.5);
    const auto bodies = tears.readBodies();
    // It tears at the end of the second substep, after bearing the load for two, and then all of it falls freely;
    // velocities of second order start half a substep later.
    const double h = double{weak.settings.timeStep} / weak.settings.substeps;
    for (uint32_t b = 1; b < 5; ++b) {
        const float fallen = weak.bodies[b].position.y() - bodies[b].position.y();
        EXPECT_NEAR(fallen, 0.5 * GRAVITY * 0.25, 2.6 * GRAVITY * 0.5 * h) << b;
        EXPECT_NEAR(bodies[b].velocity.y(), -GRAVITY * 0.5, 3 * GRAVITY * h) << b;
    }
    // The torn joint has no gap, the others hold.
    EXPECT_LT(tears.measure().worstJointGap, 3e-6f * DIAMETER);  // measured 3e-7
}

/// Held at one end, the beam's joint bears its weight half a pitch away.
TEST(JointTear, ABeamTearsWhereItIsBentHarderThanItCan)
{
    ChainSpec spec{.bodies = 2, .type = JointType::Stiff, .along = {1, 0, 0}};
    const World plain = chain(spec);
    const float weight = static_cast<float>(GRAVITY) * plain.bodies[1].mass;
    const float lever = plain.bodies[1].restCentre.x() - 0.5f * PITCH;
    for (const bool tears : {false, true}) {
        spec.strength.torque = (tears ? 0.99f : 1.01f) * weight * lever;
        const World world = chain(spec);
        Solver solver(gpu(), world);
        run(solver, world, 0.5);
        const float fallen = plain.bodies[1].position.y() - solver.readBodies()[1].position.y();
        EXPECT_NEAR(fallen, tears ? 0.5 * GRAVITY * 0.25 : 0.0, tears ? 0.06 : 1e-5);
    }
}

/// Two cubes that circle about each other hold each other with m r w^2; without the joint, they fly on straight and
/// spin on.
TEST(JointTear, WhatFliesApartKeepsItsMomentum)
{
    constexpr float SPIN = 5.0f;
    Settings settings = weightless();
    WorldBuilder plain = makeBuilder(settings);
    PairSpec pair;
    addJointedPair(plain, pair, {}, {0, 0, 0}, {0, 0, SPIN});
    const World whole = plain.build();
    const float arm = 0.5f * (whole.bodies[0].restCentre - whole.bodies[1].restCentre).norm();
    const float pull = whole.bodies[0].mass * arm * SPIN * SPIN;
    for (const bool tears : {false, true}) {
        WorldBuilder builder = makeBuilder(settings);
        // The first substep, of first order, has half of the pull, later ones more.
        pair.joint.strength.force = (tears ? 0.98f : 1.5f) * pull;
        addJointedPair(builder, pair, {}, {0, 0, 0}, {0, 0, SPIN});
        const World world = builder.build();
        Solver solver(gpu(), world);
        const Totals before = totals(world, solver.readParticles());
        run(solver, world, 1.0);
        const auto bodies = solver.readBodies();
        const float apart = (bodies[0].position - bodies[1].position).norm();
        if (!tears) {
            EXPECT_NEAR(apart, 2 * arm, 3e-7f);  // measured 3e-8
            continue;
        }
        // Straight, from the first substep on; the two pass each other without touching.
        EXPECT_NEAR(apart, 2 * arm * std::hypot(1.0f, SPIN), 0.02f * apart);
        EXPECT_NEAR(bodies[1].angularVelocity.z(), SPIN, 0.005f * SPIN);  // measured 6e-4
        double linear = 0.0, angular = 0.0;
        for (size_t b = 0; b < 2; ++b) {
            const Vector3f p = world.bodies[b].mass * bodies[b].velocity;
            linear += p.y();
            angular += bodies[b].position.cross(p).z();
        }
        const double whirl = pull / SPIN * 2 * arm;
        EXPECT_NEAR(linear, 0.0, 1e-5 * pull / SPIN);  // measured 0
        EXPECT_NEAR(angular, whirl, 0.001 * whirl);    // measured 1e-4
        EXPECT_GT(before.angularMomentum.z(), angular);
    }
}

/// Held at both ends, it forms a loop through the ground. Its joints bear about equal loads; one tears and relieves the
/// others.
TEST(JointTear, ABridgeTearsAndSwingsDown)
{
    ChainSpec spec{.bodies = 9, .along = {1, 0, 0}, .bothEnds = true};
    spec.strength.force = 20 * static_cast<float>(GRAVITY) * massFrom(chain(spec), 0);
    WorldBuilder builder = makeBuilder();
    addChain(builder, spec);
    const uint32_t block = addBox(builder, {5, 5, 5}, {{4 * PITCH, 1.5f, 0}, Quaternionf::Identity()}, {0, -3, 0});
    const World world = builder.build();
    Solver solver(gpu(), world);
    double fastest = 0.0;
    for (int i = 0; i < 15; ++i) {
        run(solver, world, 0.1);
        for (const BodyState& body : solver.readBodies()) fastest = std::max<double>(fastest, body.velocity.norm());
        EXPECT_LT(solver.measure().worstJointGap, 0.003f * DIAMETER) << i;
    }
    const ParticleState state = solver.readParticles();
    EXPECT_EQ(std::ranges::count_if(world.joints, [&](const Joint& joint) { return state.torn[joint.particles[0]]; }),
              1);
    EXPECT_LT(solver.readBodies()[block].position.y(), -5.0f) << "it was caught";
    // Nothing is faster than in free fall for all that time.
    EXPECT_LT(fastest, 3 + GRAVITY * 1.5);
    // One end holds what hangs from it.
    EXPECT_GT(std::max(solver.readBodies()[1].position.y(), solver.readBodies()[7].position.y()), -PITCH);
}

/// A body stands on another that it may pass while they are joined. After the joint tears, it lies on the layer between
/// them, which belongs to the lower one.
TEST(JointTear, WhatPassedEachOtherTouchesOnceItIsTorn)
{
    for (const bool tears : {false, true}) {
        ChainSpec spec{.bodies = 2, .type = JointType::Stiff, .along = {0, 1, 0}};
        spec.strength.force = tears ? 1.0f : 1e6f;
        WorldBuilder builder = makeBuilder();
        addChain(builder, spec);
        builder.filterPair(0, 1);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 1.5);
        EXPECT_EQ(solver.readParticles().torn[world.joints[0].particles[0]], tears);
        EXPECT_NEAR(solver.readBodies()[1].position.y(), world.bodies[1].position.y(), 0.01f * DIAMETER);
    }
}

/// A hinge that falls against its limit, where a torque would hold it.
TEST(JointTear, AHingeTearsAtItsLimit)
{
    for (const bool tears : {false, true}) {
        WorldBuilder builder = makeBuilder();
        PairSpec pair;
        pair.apart = 6.0f;
        pair.motionOfA = Motion::Fixed;
        pair.joint.type = JointType::Hinge;
        pair.joint.limits.bend = {-0.5f, 0.5f};
        if (tears) pair.joint.strength.torque = 10.0f;
        addJointedPair(builder, pair);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 1.5);
        EXPECT_EQ(solver.readBodies()[1].position.y() < -3.0f, tears);
    }
}

}  // namespace

}  // namespace knuckle::test
