#include <algorithm>
#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

constexpr double DEGREE = M_PI / 180.0;

/// Angles [degrees] of the turn from body A to body B about A's axes, as a rotation vector.
Eigen::Vector3d turnBetween(const std::vector<BodyState>& bodies)
{
    const Quaternionf turn = bodies[0].rotation.conjugate() * bodies[1].rotation;
    const Eigen::AngleAxisf angle(turn);
    Vector3f vector = angle.angle() * angle.axis();
    if (angle.angle() > static_cast<float>(M_PI)) vector -= 2.0f * static_cast<float>(M_PI) * angle.axis();
    return vector.cast<double>() / DEGREE;
}

struct Energy {
    double least = INFINITY, rise = 0.0;  ///< The rise over the least so far [J].
};

/// Measures every tenth of a second, this many times.
Energy watchEnergy(Solver& solver, const World& world, int times)
{
    Energy seen;
    for (int i = 0; i < times; ++i) {
        const double now = energyOf(world, solver.readParticles());
        seen.least = std::min(seen.least, now);
        seen.rise = std::max(seen.rise, now - seen.least);
        run(solver, world, 0.1);
    }
    return seen;
}

TEST(Joint, AStiffCantileverStaysStraightUnderItsWeight)
{
    const World world = jointedPair(JointType::Stiff, {}, {}, {0, 0, 0}, {0, 0, 0}, true);
    Solver solver(gpu(), world);
    run(solver, world, 3.0);
    EXPECT_LT(turnBetween(solver.readBodies()).norm(), 1e-3);     // measured 0
    EXPECT_LT(solver.measure().worstJointGap, 1e-6f * DIAMETER);  // measured 0
}

TEST(Joint, AHingeTurnsAboutItsAxisOnly)
{
    const World world = jointedPair(JointType::Hinge, {}, {}, {0, 0, 0}, {0, 0, 0}, true);
    Solver solver(gpu(), world);
    double widest = 0.0, forbidden = 0.0;
    for (int i = 0; i < 30; ++i) {
        run(solver, world, 0.1);
        const Eigen::Vector3d turn = turnBetween(solver.readBodies());
        widest = std::max(widest, std::abs(turn.z()));
        forbidden = std::max(forbidden, turn.head<2>().norm());
    }
    // It falls until the cubes touch; the load is perpendicular to the axis.
    EXPECT_GT(widest, 30.0);
    EXPECT_LT(forbidden, 1.5e-4);  // measured 1.7e-5
}

TEST(Joint, AHingeHoldsALoadAboutAForbiddenAxis)
{
    // Gravity along the hinge's axis bends the pair about y, which a hinge forbids.
    Settings settings;
    settings.gravity = {0, 0, -9.81f};
    const World world = jointedPair(JointType::Hinge, settings, {}, {0, 0, 0}, {0, 0, 0}, true);
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    EXPECT_LT(turnBetween(solver.readBodies()).head<2>().norm(), 1e-3);  // measured 0
}

TEST(Joint, ALimitedHingeStaysStraightOnItsBlockedSide)
{
    // The limiting particles lie on the side along x axis = -y: gravity bends the pair towards it.
    const World world = jointedPair(JointType::Hinge, {}, {}, {0, 0, 0}, {0, 0, 0}, true, 1);
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    EXPECT_LT(turnBetween(solver.readBodies()).norm(), 0.2);  // measured 0.022
    const World open = jointedPair(JointType::Hinge, {}, {}, {0, 0, 0}, {0, 0, 0}, true, -1);
    Solver other(gpu(), open);
    run(other, open, 2.0);
    EXPECT_GT(turnBetween(other.readBodies()).norm(), 30.0);
}

TEST(Joint, ABallTwistsFreely)
{
    // B alone turns about the line between the bodies. Required: 90 % of the rate after 2 s.
    World world = jointedPair(JointType::Ball, weightless());
    for (Particle& particle : world.particles)
        if (particle.body == 1) particle.velocity = Vector3f(4, 0, 0).cross(particle.position);
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    const auto bodies = solver.readBodies();
    const Vector3f relative = bodies[1].angularVelocity - bodies[0].angularVelocity;
    EXPECT_GT(relative.x(), 0.9f * 4.0f);
}

TEST(Joint, ABallSwingsUntilContactStopsIt)
{
    const World world = jointedPair(JointType::Ball, {}, {}, {0, 0, 0}, {0, 0, 0}, true);
    Solver solver(gpu(), world);
    double widest = 0.0;
    for (int i = 0; i < 30; ++i) {
        run(solver, world, 0.1);
        widest = std::max(widest, turnBetween(solver.readBodies()).norm());
    }
    // The lower edges, sqrt(2) diameters from the pivot and 135 degrees apart as seen from it, meet at one diameter: 90
    // - 2 asin(1/(2 sqrt 2)) = 48.6 degrees; lattice edges let it swing a little further.
    EXPECT_GT(widest, 40.0);
    EXPECT_LT(widest, 60.0);
}

TEST(Joint, AUniversalJointBendsBothWaysButDoesNotTwist)
{
    for (const Vector3f& gravity : {Vector3f(0, -9.81f, 0), Vector3f(0, 0, -9.81f)}) {
        Settings settings;
        settings.gravity = gravity;
        const World world = jointedPair(JointType::Universal, settings, {}, {0, 0, 0}, {0, 0, 0}, true);
        Solver solver(gpu(), world);
        double bend = 0.0, twist = 0.0;
        for (int i = 0; i < 20; ++i) {
            run(solver, world, 0.1);
            const Eigen::Vector3d turn = turnBetween(solver.readBodies());
            bend = std::max(bend, turn.tail<2>().norm());
            twist = std::max(twist, std::abs(turn.x()));
        }
        EXPECT_GT(bend, 25.0) << gravity.transpose();
        EXPECT_LT(twist, 3e-4) << gravity.transpose();  // measured 4e-5
    }
}

TEST(Joint, GapsAreSmallAtRest)
{
    for (JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal}) {
        const World world = jointedPair(type, {}, {}, {0, 0, 0}, {0, 0, 0}, true);
        Solver solver(gpu(), world);
        run(solver, world, 6.0);
        // Measured 3.4e-7.
        EXPECT_LT(solver.measure().worstJointGap, 3e-6f * DIAMETER) << "joint type " << static_cast<int>(type);
    }
}

/// Arms one particle thick: only their particles' size gives them a moment about themselves.
TEST(Joint, ThinLimbsGetNoEnergy)
{
    for (int k = 0; k < 4; ++k) {
        WorldBuilder builder = makeBuilder();
        builder.addCollider(floorPlane());
        builder.beginObject("figure");
        const uint32_t torso = builder.addBody("torso", boxLattice({3, 5, 3}, DIAMETER), 0);
        for (float side : {-1.0f, 1.0f}) {
            std::vector<Vector3f> arm = boxLattice({3, 1, 1}, DIAMETER);
            for (Vector3f& p : arm) p += DIAMETER * Vector3f(4 * side, 2, 0);
            JointSpec joint;
            joint.anchor = DIAMETER * Vector3f(2 * side, 2, 0);
            joint.along = {side, 0, 0};
            builder.addJoint(torso, builder.addBody("arm", arm, 0), joint);
        }
        const auto turn = static_cast<float>(k);
        const Vector3f axis = Vector3f(1, std::sin(turn), std::cos(2 * turn)).normalized();
        builder.endObject({Vector3f(0, 1.6f, 0), Quaternionf(Eigen::AngleAxisf(turn, axis))}, {0, 0, 0}, 2.0f * axis);
        const World world = builder.build();
        Solver solver(gpu(), world);
        const double rise = watchEnergy(solver, world, 30).rise;
        double mass = 0.0;
        for (const Particle& p : world.particles) mass += p.mass;
        // Parts that sink in by a blow are pushed out again.
        EXPECT_LT(rise, mass * GRAVITY * 0.004 * DIAMETER) << k;  // measured 5e-4
    }
}

/// A torso with two arms: balls at the shoulders, hinges at the elbows.
World figureWithElbows(const Vector3f& spin)
{
    WorldBuilder builder = makeBuilder(weightless());
    builder.beginObject("figure");
    const uint32_t torso = builder.addBody("torso", boxLattice({3, 5, 3}, DIAMETER), 0);
    for (const float side : {-1.0f, 1.0f}) {
        const auto part = [&](const char* name, float first, const Eigen::Vector3i& counts) {
            std::vector<Vector3f> places = boxLattice(counts, DIAMETER);
            for (Vector3f& p : places) p += DIAMETER * Vector3f(side * first, 2, 0);
            return builder.addBody(name, places, 0);
        };
        JointSpec joint;
        joint.anchor = DIAMETER * Vector3f(2 * side, 2, 0);
        joint.along = {side, 0, 0};
        const uint32_t upper = part("upper arm", 4, {3, 1, 1});
        builder.addJoint(torso, upper, joint);
        joint.type = JointType::Hinge;
        joint.anchor = DIAMETER * Vector3f(6 * side, 2, 0);
        builder.addJoint(upper, part("forearm", 8, {3, 3, 3}), joint);
    }
    builder.endObject({}, {0, 0, 0}, spin);
    return builder.build();
}

TEST(Joint, AHingeDrivesNothing)
{
    // Nothing acts on it: its energy never rises, and its angular momentum is constant. After a hinge has turned, its
    // last torque is no longer perpendicular to its axis; the part along it would drive the hinge.
    for (const Vector3f& spin : {Vector3f(3, 12, 5), Vector3f(9, 2, 9)}) {
        const World world = figureWithElbows(spin);
        Solver solver(gpu(), world);
        run(solver, world, 0.1);
        const Eigen::Vector3d start = totals(world, solver.readParticles()).angularMomentum;
        const Energy energy = watchEnergy(solver, world, 40);
        const Eigen::Vector3d end = totals(world, solver.readParticles()).angularMomentum;
        EXPECT_LT(energy.rise, 0.002 * energy.least) << spin.transpose();          // measured 1e-3
        EXPECT_LT((end - start).norm(), 0.02 * start.norm()) << spin.transpose();  // measured 5e-3
    }
}

}  // namespace knuckle::test
