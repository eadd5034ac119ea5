#include "app/files/robot/robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace knuckle {
namespace {

/// A plank of 3 x 7 x 3 particles along +Y on a cube of 3 x 3 x 3, which shares the cube's upper face.
Actor plankOnCube(ActorJoint joint)
{
    Actor actor;
    actor.name = "a \"plank\" & more";
    actor.diameter = 0.1f;
    actor.bodies.resize(2);
    actor.bodies[0].name = "cube";
    actor.bodies[1].name = "plank";
    actor.bodies[1].parent = 0;
    for (int y = 0; y < 9; ++y)
        for (int z = -1; z <= 1; ++z)
            for (int x = -1; x <= 1; ++x) {
                const auto index = static_cast<uint32_t>(actor.particles.size());
                actor.particles.push_back(0.1f * Vector3f(float(x), float(y), float(z)));
                if (y <= 2) actor.bodies[0].particles.push_back(index);
                if (y >= 2) actor.bodies[1].particles.push_back(index);
                if (y == 2) joint.sharedParticles.push_back(index);
            }
    joint.name = "plank";
    joint.parent = 0, joint.child = 1;
    joint.anchor = {0, 0.2f, 0};
    actor.joints = {joint};
    return actor;
}

ActorJoint hinge()
{
    ActorJoint joint;
    joint.type = JointType::Hinge;
    joint.axis = {0, 0, 1};
    joint.limits.bend = {-0.5f, 1.0f};
    return joint;
}

TEST(Robot, HasMassesAndInertiasOfItsBodiesWithZUp)
{
    const Robot robot = robotOf(plankOnCube(hinge()));
    ASSERT_EQ(robot.links.size(), 2u);
    // 81 particles of 1 kg, nine of them half in each body.
    EXPECT_NEAR(robot.links[0].mass, 22.5f, 1e-4f);
    EXPECT_NEAR(robot.links[1].mass, 58.5f, 1e-4f);
    EXPECT_NEAR((robot.links[1].origin - Vector3f(0, 0, 0.2f)).norm(), 0.0f, 1e-6f);
    // Layers of 9 kg from 0.3 to 0.8 m, and 4.5 kg at 0.2 m.
    const double centre = (4.5 * 0.2 + 9.0 * (0.3 + 0.4 + 0.5 + 0.6 + 0.7 + 0.8)) / 58.5;
    EXPECT_NEAR((robot.links[1].centre - Vector3f(0, 0, float(centre))).norm(), 0.0f, 1e-5f);
    // About +Z, across layers of 3 x 3: 2/3 of d^2 each for x and y, and 0.1 d^2 of the balls themselves.
    EXPECT_NEAR(robot.links[1].inertia(2, 2), 58.5 * 0.01 * (4.0 / 3.0 + 0.1), 1e-3);
    EXPECT_NEAR(robot.links[1].inertia(0, 1), 0.0, 1e-5);
    double along = 4.5 * std::pow(0.2 - centre, 2);
    for (int k = 3; k <= 8; ++k) along += 9.0 * std::pow(0.1 * k - centre, 2);
    EXPECT_NEAR(robot.links[1].inertia(0, 0), along + 58.5 * 0.01 * (2.0 / 3.0 + 0.1), 1e-3);
}

TEST(Robot, CapsulesReachAsFarAsTheirParticles)
{
    const RobotLink plank = robotOf(plankOnCube(hinge())).links[1];
    // 0.3 m square: a cylinder of as much spread, 0.09 / 6 = R^2 / 2.
    EXPECT_NEAR(plank.radius, std::sqrt(0.03), 2e-3);
    const float low = std::min(plank.ends[0].z(), plank.ends[1].z()) - plank.radius;
    const float high = std::max(plank.ends[0].z(), plank.ends[1].z()) + plank.radius;
    EXPECT_NEAR(low, 0.15f, 1e-4f);
    EXPECT_NEAR(high, 0.85f, 1e-4f);
    EXPECT_NEAR(plank.ends[0].head<2>().norm() + plank.ends[1].head<2>().norm(), 0.0f, 1e-4f);
}

TEST(Robot, HingesKeepAxisAndRange)
{
    const Robot robot = robotOf(plankOnCube(hinge()));
    ASSERT_EQ(robot.links[1].turns.size(), 1u);
    // +Z of the actor points to -Y where +Z is up.
    EXPECT_NEAR((robot.links[1].turns[0].axis - Vector3f(0, -1, 0)).norm(), 0.0f, 1e-6f);
    EXPECT_EQ(robot.links[1].turns[0].range.lowest, -0.5f);
    EXPECT_EQ(robot.links[1].turns[0].range.highest, 1.0f);
    const std::string urdf = urdfOf(robot);
    EXPECT_NE(urdf.find("<robot name=\"a &quot;plank&quot; &amp; more\">"), std::string::npos);
    EXPECT_NE(urdf.find("<joint name=\"plank\" type=\"revolute\">"), std::string::npos);
    EXPECT_NE(urdf.find("<axis xyz=\"0 -1 0\"/>\n    <limit lower=\"-0.5\" upper=\"1\""), std::string::npos);
    EXPECT_NE(
        mjcfOf(robot).find("<joint name=\"plank\" type=\"hinge\" axis=\"0 -1 0\" limited=\"true\" range=\"-0.5 1\"/>"),
        std::string::npos);
}

TEST(Robot, ConesBecomeRangesAboutTheirMiddle)
{
    ActorJoint ball;
    ball.axis = {0, 1, 0};
    ball.limits.swing = 0.6f;
    ball.limits.twist = {-0.3f, 0.4f};
    // The cone leans by 0.2 about +X, from +Y to +Z.
    ball.limits.cone = {0, std::cos(0.2f), std::sin(0.2f)};
    const RobotLink link = robotOf(plankOnCube(ball)).links[1];
    ASSERT_EQ(link.turns.size(), 3u);
    EXPECT_FALSE(link.isBall);
    for (const RobotTurn& turn : {link.turns[0], link.turns[1]}) {
        // Of the lean, the part about this axis.
        const float part = 0.2f * turn.axis.x();
        EXPECT_NEAR(turn.range.lowest, part - 0.6f, 1e-5f);
        EXPECT_NEAR(turn.range.highest, part + 0.6f, 1e-5f);
        EXPECT_NEAR(turn.axis.z(), 0.0f, 1e-6f) << "across the ball's own";
    }
    EXPECT_NEAR(link.turns[2].range.lowest, -0.3f, 1e-6f);
    EXPECT_NEAR((link.turns[2].axis - Vector3f(0, 0, 1)).norm(), 0.0f, 1e-6f);
    ActorJoint free;
    free.axis = {0, 1, 0};
    const Robot loose = robotOf(plankOnCube(free));
    EXPECT_NE(mjcfOf(loose).find("type=\"ball\""), std::string::npos);
    EXPECT_NE(urdfOf(loose).find("<joint name=\"plank_twist\" type=\"continuous\">"), std::string::npos);
}

}  // namespace
}  // namespace knuckle
