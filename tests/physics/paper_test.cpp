#include <cmath>
#include <numbers>

#include "app/bench/bench_worlds.h"
#include "sim/world/builder/parts/joints.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// A tower of cubes on the floor.
World tower(const Settings& settings, int cubes = 5)
{
    WorldBuilder builder = makeBuilder(settings);
    builder.addCollider(floorPlane());
    for (int k = 0; k < cubes; ++k)
        addBox(builder, {3, 3, 3}, {Vector3f(0, (1.5f + 3.0f * static_cast<float>(k)) * DIAMETER, 0)});
    return builder.build();
}

float fastest(Solver& solver)
{
    return solver.measure().maxSpeed;
}

/// A pair whose first body is fixed and whose second hangs from it, released `degrees` from the vertical.
World pendulum(JointType type, double degrees)
{
    const auto angle = static_cast<float>((degrees - 90.0) * std::numbers::pi / 180.0);
    const Pose pose{Vector3f(0, 3, 0), Quaternionf(Eigen::AngleAxisf(angle, Vector3f::UnitZ()))};
    Settings settings = paperSettings();
    settings.reduction = ReductionKind::Thread;  // the same sums in a fifth of the dispatches
    return jointedPair(type, settings, pose, {0, 0, 0}, {0, 0, 0}, true);
}

/// The angle of the second body's centre from straight below the joint [degrees].
double tilt(const BodyState& hanging)
{
    const Vector3f arm = hanging.position - Vector3f(0, 3, 0);
    return std::atan2(std::hypot(arm.x(), arm.z()), -arm.y()) * 180.0 / std::numbers::pi;
}

}  // namespace

TEST(Paper, ATowerOfFiveCubesStandsAndItsBodiesStayRigid)
{
    const World world = tower(paperSettings());
    Solver solver(gpu(), world);
    for (int second = 0; second < 10; ++second) {
        run(solver, world, 1.0);
        // Single precision at 1.5 m leaves 2e-7 m.
        EXPECT_LT(solver.measure().worstShapeError, 2e-6f * DIAMETER);  // measured 2.3e-7
    }
    const auto bodies = solver.readBodies();
    for (size_t b = 0; b < bodies.size(); ++b) {
        const Vector3f off = bodies[b].position - world.bodies[b].position;
        // A load of up to five cubes presses each contact by a few tenths of g h^2 = 0.17 mm.
        EXPECT_LT(std::hypot(off.x(), off.z()), 2e-4f * DIAMETER) << "cube " << b;  // measured 2.4e-5
        EXPECT_LT(std::abs(off.y()), 0.06f * DIAMETER) << "cube " << b;             // measured 0.0075
    }
    EXPECT_LT(solver.measure().meanPenetration, 0.012f * DIAMETER);  // measured 0.0015
}

TEST(Paper, WhatHasComeToRestFreezesAndWakesWhenSomethingHitsIt)
{
    WorldBuilder builder = makeBuilder(paperSettings());
    builder.addCollider(floorPlane());
    for (int k = 0; k < 3; ++k)
        addBox(builder, {3, 3, 3}, {Vector3f(0, (1.5f + 3.0f * static_cast<float>(k)) * DIAMETER, 0)});
    // Thrown up at 15 m/s, it returns after 3.06 s.
    addBox(builder, {4, 4, 4}, {Vector3f(0, 12.0f * DIAMETER, 0)}, {0, 15, 0});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.5);
    auto bodies = solver.readBodies();
    for (size_t b = 0; b < 3; ++b) EXPECT_EQ(bodies[b].velocity.norm(), 0.0f) << "cube " << b;
    EXPECT_GT(bodies[3].velocity.norm(), 5.0f) << "one that flies never freezes";
    int steps = 0;
    while (solver.readBodies()[2].velocity.norm() == 0.0f && steps++ < 90) run(solver, world, 1.0 / 60.0);
    EXPECT_LT(steps, 90);
}

TEST(Paper, WhatLosesItsSupportFallsOutOfItsFreeze)
{
    // A cube on two others; a fast cube knocks the left one away.
    WorldBuilder builder = makeBuilder(paperSettings(), 0.05f);
    builder.addCollider(floorPlane(0.05f));
    for (const float x : {-2.0f, 2.0f}) addBox(builder, {3, 3, 3}, {Vector3f(x * DIAMETER, 1.5f * DIAMETER, 0)});
    addBox(builder, {7, 3, 3}, {Vector3f(0, 4.5f * DIAMETER, 0)});
    const float speed = 8.0f;
    addBox(builder, {3, 3, 3}, {Vector3f(-2.0f * DIAMETER, 1.5f * DIAMETER, -2.5f * speed)}, {0, 0, speed});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    EXPECT_EQ(solver.readBodies()[2].velocity.norm(), 0.0f);
    run(solver, world, 4.0);
    EXPECT_LT(solver.readBodies()[2].position.y(), 4.0f * DIAMETER) << "it hangs in the air";
}

TEST(Paper, APendulumFreezesOnlyWhereItHangs)
{
    const World world = pendulum(JointType::Ball, 20.0);
    Solver solver(gpu(), world);
    double greatest = 0.0;
    for (int k = 0; k < 8; ++k) {
        run(solver, world, 0.25);
        greatest = std::max(greatest, tilt(solver.readBodies()[1]));
    }
    EXPECT_GT(greatest, 5.0);
    // First-order velocities damp the swing. A body that stays within 1/8 d for a second has an acceleration of less
    // than 8 (d/8) / s^2, 0.1 m/s2: 0.6 degrees.
    int seconds = 0;
    while (fastest(solver) > 0.0f && seconds++ < 120) run(solver, world, 1.0);
    EXPECT_LT(seconds, 120);
    EXPECT_LT(tilt(solver.readBodies()[1]), 1.0);
}

TEST(Paper, JointsHangAsTheDefaultsDo)
{
    // By statics a ball, a hinge and a universal joint let a body hang straight down; a stiff one holds it level. It
    // gives way by the load over the speed at which the iterations converge: below a degree.
    for (const JointType type : {JointType::Ball, JointType::Hinge, JointType::Universal, JointType::Stiff}) {
        const bool stiff = type == JointType::Stiff;
        const World world = pendulum(type, stiff ? 90.0 : 15.0);
        Solver solver(gpu(), world);
        int seconds = 0;
        do run(solver, world, 1.0);
        while (fastest(solver) > 0.0f && ++seconds < 120);
        EXPECT_LT(seconds, 120) << jointTypeName(type);
        EXPECT_NEAR(tilt(solver.readBodies()[1]), stiff ? 90.0 : 0.0, 2.0) << jointTypeName(type);
        EXPECT_LT(solver.measure().worstJointGap, 0.02f * DIAMETER) << jointTypeName(type);
    }
}

TEST(Paper, AHeavyLoadHangsFromAChain)
{
    // Ten links with a load of ten times their mass at the end: the joints stay closed.
    WorldBuilder builder = makeBuilder(paperSettings());
    Material heavy;
    heavy.name = "heavy";
    heavy.density = 10000.0f;
    const uint32_t load = builder.addMaterial(heavy);
    builder.beginObject("chain");
    uint32_t last = 0;
    for (int k = 0; k < 10; ++k) {
        std::vector<Vector3f> cube = boxLattice({3, 3, 3}, DIAMETER);
        for (Vector3f& p : cube) p.y() -= 4.0f * DIAMETER * static_cast<float>(k);
        const uint32_t body = builder.addBody("link", cube, k == 9 ? load : 0,
                                              k == 0 ? Motion::Fixed : Motion::Dynamic);
        JointSpec joint;
        joint.anchor = {0, (2.0f - 4.0f * static_cast<float>(k)) * DIAMETER, 0};
        joint.along = {0, -1, 0};
        if (k > 0) builder.addJoint(last, body, joint);
        last = body;
    }
    builder.endObject({Vector3f(0, 6, 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 5.0);
    EXPECT_LT(solver.measure().worstJointGap, 0.4f * DIAMETER);  // measured 0.043
    EXPECT_LT(fastest(solver), 1e-4f);                           // measured 0: frozen
}

TEST(Paper, WhatStartsCaughtInEachOtherPartsAndIsNotThrown)
{
    // Two dozen cubes in half the room that they need, each with its own rotation. Only gravity and a bounded recovery
    // give speed: from 1.3 m 5 m/s, and somewhat more at turning corners. If exit directions did not turn with their
    // bodies, the cubes would stay in each other by 20 % of a diameter and drive themselves to 9-40 m/s.
    WorldBuilder builder = makeBuilder(paperSettings());
    builder.addCollider(floorPlane());
    for (int k = 0; k < 24; ++k) {
        const Vector3f cell = Eigen::Vector3i(k % 3, k / 6, k / 3 % 2).cast<float>();
        const Vector3f place(0.18f * cell.x(), 0.4f + 0.2f * cell.y(), 0.18f * cell.z());
        const Quaternionf turn(Eigen::AngleAxisf(0.7f * static_cast<float>(k), Vector3f(1, 2, 3).normalized()));
        addBox(builder, {3, 3, 3}, {place, turn});
    }
    const World world = builder.build();
    Solver solver(gpu(), world);
    for (int k = 0; k < 32; ++k) {
        run(solver, world, 0.25);
        EXPECT_LT(fastest(solver), 7.0f) << "at " << 0.25 * (k + 1) << " s";
    }
    EXPECT_LT(fastest(solver), 1e-4f);  // measured 0: frozen
    const Measures m = solver.measure();
    EXPECT_LT(m.meanPenetration, 1.5e-4f * DIAMETER);   // measured 1.9e-5
    EXPECT_LT(m.worstPenetration, 1.6e-4f * DIAMETER);  // measured 2.1e-5
}

TEST(Paper, APileKeepsStillForAMinute)
{
    Settings settings = paperSettings();
    settings.reduction = ReductionKind::Thread;
    const World world = table2World(12, settings);
    Solver solver(gpu(), world);
    run(solver, world, 10.0);
    const auto before = solver.readBodies();
    run(solver, world, 50.0);
    const auto after = solver.readBodies();
    // Bodies at rest are frozen, and frozen bodies do not move: measured 0.
    for (size_t b = 0; b < before.size(); ++b)
        EXPECT_LT((after[b].position - before[b].position).norm(), 1e-6f * DIAMETER) << "body " << b;
    const Measures m = solver.measure();
    EXPECT_LT(m.maxSpeed, 1e-6f);
    EXPECT_LT(m.worstShapeError, 8e-6f * DIAMETER);  // measured 9e-7
    EXPECT_LT(m.meanJointGap, 2e-4f * DIAMETER);     // measured 2.2e-5
    EXPECT_LT(m.worstJointGap, 3e-4f * DIAMETER);    // measured 3.4e-5
    EXPECT_LT(m.meanPenetration, 2e-4f * DIAMETER);  // measured 2.6e-5
}

}  // namespace knuckle::test
