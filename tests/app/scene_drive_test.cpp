#include <cmath>

#include "tests/app/one_object_scene.h"

namespace knuckle::test {

namespace {

/// The project's figure with its dance and additional fields.
std::string dancer(const std::string& fields)
{
    return R"({"type": "actor", "file": "FILE", "animation": {"clip": "dance"})" + fields + "}";
}

uint32_t bodyOf(const World& world, const std::string& name)
{
    for (uint32_t b = 0; b < world.bodies.size(); ++b)
        if (world.bodies[b].name == name) return b;
    return NO_INDEX;
}

}  // namespace

TEST(SceneDrive, SaysHowEachJointIsDriven)
{
    const World world = worldOf(dancer(R"(, "drive": {"frequency": 5, "dampingRatio": 0.5, "maxTorque": 40,
        "bones": [{"name": "*ARM*", "stiffness": 30, "damping": 2}, {"name": "head"}],
        "strength": [{"time": 0, "value": 1}, {"time": 2, "value": 0.5, "ease": "smooth"}],
        "pin": {"bodies": ["chest", "hips"], "frequency": 3, "maxForce": 500},
        "hitReaction": {"impulse": 20}, "knockOut": {"distance": 0.4}}, "repeat": {"counts": [2, 1, 1]})"));
    ASSERT_EQ(world.puppets.size(), 2u);
    for (const Puppet& puppet : world.puppets) {
        const DriveSpring &shin = puppet.joints[bodyOf(world, "shin.L")],
                          &arm = puppet.joints[bodyOf(world, "forearm.R")];
        EXPECT_EQ(shin.frequency, 5.0f);
        EXPECT_EQ(shin.dampingRatio, 0.5f);
        EXPECT_EQ(shin.greatestTorque, 40.0f);
        EXPECT_EQ(arm.stiffness, 30.0f);
        EXPECT_EQ(arm.damping, 2.0f);
        EXPECT_TRUE(std::isinf(arm.greatestTorque));
        EXPECT_FALSE(puppet.joints[bodyOf(world, "head")].acts());
        ASSERT_EQ(puppet.pins.size(), 2u);
        EXPECT_EQ(puppet.pins[0].body, bodyOf(world, "chest"));
        EXPECT_EQ(puppet.pins[1].spring.greatestForce, 500.0f);
        ASSERT_EQ(puppet.strength.size(), 2u);
        EXPECT_TRUE(puppet.strength[1].smooth);
        EXPECT_EQ(puppet.hit.impulse, 20.0f);
        EXPECT_EQ(puppet.knockOut.distance, 0.4f);
        EXPECT_FALSE(puppet.caught);
    }
    EXPECT_EQ(world.puppets[1].animation, 1u);
    for (const Body& body : world.bodies) EXPECT_EQ(body.releaseTime, 0.0f) << body.name;
}

TEST(SceneDrive, ReleasesMakeItDrivenOrLimp)
{
    const World world = worldOf(dancer(R"(, "drive": {"frequency": 5}, "catch": {"time": 6},
        "release": [{"time": 1, "becomes": "driven"}, {"time": 2, "below": "thigh.L"}, {"time": 8}])"));
    const Puppet& puppet = world.puppets.at(0);
    const uint32_t shin = bodyOf(world, "shin.L"), head = bodyOf(world, "head");
    EXPECT_EQ(world.bodies[shin].releaseTime, 1.0f);
    EXPECT_EQ(puppet.limpTimes[shin], 2.0f);
    EXPECT_TRUE(std::isinf(puppet.limpTimes[head]));
    ASSERT_TRUE(puppet.caught);
    EXPECT_EQ(puppet.caught->releaseTimes[head], 8.0f);
    EXPECT_EQ(puppet.caught->limpTimes[head], 8.0f);
}

/// A figure that is still animated when it is caught is let go by later releases.
TEST(SceneDrive, AReleaseBehindACatchIsTheSecondOne)
{
    const World world = worldOf(dancer(R"(, "catch": {"time": 1}, "release": {"time": 2})"));
    EXPECT_EQ(world.puppets.at(0).caught->releaseTimes[3], 2.0f);
    for (const Body& body : world.bodies) EXPECT_TRUE(mayBeLetGo(body)) << body.name;
}

TEST(SceneDrive, WhatIsWrongIsOneLine)
{
    const struct {
        std::string fields, complaint;
    } cases[] = {
        {R"(, "drive": {"frequency": -1})", "/objects/0/drive/frequency: -1 is below the minimum 0 [Hz]"},
        {R"(, "drive": {"frequency": 5, "stiffness": 1})",
         "/objects/0/drive: has a frequency and a stiffness or damping; give one of them"},
        {R"(, "drive": {"frequency": 5, "bones": [{"name": "wing*"}]})",
         "/objects/0/drive/bones/0/name: fits no body; "},
        {R"(, "drive": {"frequency": 5, "pin": {"bodies": ["tail"]}})",
         "/objects/0/drive/pin/bodies/0: there is no body \"tail\"; "},
        {R"(, "drive": {"frequency": 5, "strength": [{"time": 1, "value": 1}, {"time": 0, "value": 1}]})",
         "/objects/0/drive/strength/1/time: must not be before that of the key before"},
        {R"(, "release": {"time": 1, "becomes": "driven"})", "/objects/0/release/becomes: is for what has a `drive`"},
        {R"(, "catch": {"time": 2, "clip": "waltz"})", "/objects/0/catch/clip: there is no clip \"waltz\"; "},
        {R"(, "catch": {"time": 2, "near": 0})", "/objects/0/catch/near: 0 must be above 0 [m]"},
    };
    for (const auto& wrong : cases)
        EXPECT_TRUE(complaintOf(dancer(wrong.fields)).starts_with(wrong.complaint))
            << complaintOf(dancer(wrong.fields));
    const std::string limp = R"({"type": "actor", "file": "FILE", )";
    EXPECT_EQ(complaintOf(limp + R"("drive": {"frequency": 5}})"),
              "/objects/0/drive: is towards an `animation`; give one, or take it away");
    EXPECT_EQ(complaintOf(limp + R"("catch": {"time": 5}})"),
              "/objects/0/catch: is for what has an `animation` or a `pose`; give one");
}

}  // namespace knuckle::test
