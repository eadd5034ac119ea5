#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

/// Joints between bodies of a scene, as users write them.
using SceneJoints = test::CliTest;

TEST_F(SceneJoints, TellWhatIsWrongWithTheirBodiesAndPlace)
{
    const struct {
        const char* joint;
        const char* message;
    } cases[] = {
        {R"("bodies": ["dor", "world"], "at": [0, 1, 0])",
         "/bodies/0: there is no body \"dor\"; did you mean \"door\"?"},
        {R"("bodies": ["door", "door"], "at": [0, 1, 0])",
         "/bodies: names \"door\" twice; a joint holds two bodies, or one and \"world\""},
        {R"("bodies": ["world", "world"], "at": [0, 1, 0])",
         "/bodies: names \"world\" twice; a joint holds two bodies, or one and \"world\""},
        {R"("bodies": ["door", "chain"], "at": [0, 1, 0])",
         "/bodies/1: \"chain\" has 2 bodies; name one of them, such as \"chain/body_1\""},
        {R"("bodies": ["door", "sand"], "at": [0, 1, 0])",
         "/bodies/1: \"sand\" is not one rigid body; known: world, door, chain/body_1, chain/body_2"},
        {R"("bodies": ["door", "world"], "at": [0, 9, 0])",
         "/at: is 7.9 m from the nearest of its bodies; put it where they meet"},
        {R"("bodies": ["door", "world"], "at": [0, 1, 0], "axis": [0, 0, 0])",
         "/axis: must not be zero; for instance [0, 0, 1]"},
        {R"("bodies": ["door", "world"], "at": [0, 1, 0], "limits": { "swing": 20 })",
         "/limits/swing: is no limit of a hinge joint; a ball has `swing`, `cone` and `twist`, a hinge `bend`, a "
         "universal joint `bend` and `secondBend`"},
        {R"("bodies": ["door"], "at": [0, 1, 0])", "/bodies: is an array of 1, must be an array of 2 strings"},
    };
    for (const auto& entry : cases) {
        folder.write("joint.json", std::string(R"({ "objects": [
            { "type": "rigid", "shape": "box", "name": "door", "position": [0, 1, 0] },
            { "type": "joined", "name": "chain", "position": [3, 1, 0] },
            { "type": "grains", "shape": "box", "size": [0.2, 0.2, 0.2], "name": "sand", "position": [6, 1, 0] },
            { "type": "joint", "kind": "hinge", )") +
                                       entry.joint + "} ] }");
        expectError(run({"check", "joint.json"}), 2, std::string("joint.json: /objects/3") + entry.message);
    }
}

TEST_F(SceneJoints, TellWhatIsWrongWithTheirMotorsAndSprings)
{
    const struct {
        const char* joint;
        const char* message;
    } cases[] = {
        {R"("kind": "ball", "motor": { "speed": 3, "torque": 10 })",
         "/motor: turns a hinge; a ball joint has no one axis to turn about"},
        {R"("kind": "slider")", "/kind: \"slider\" is no joint here: bodies that share particles turn about them, but "
                                "cannot slide along them; "
                                "guide the body between smooth colliders, or move it by a crank and a rod"},
        {R"("kind": "hinge", "motor": { "torque": 10 })",
         "/motor: says neither how fast nor where to; give its `speed` or its `angle`"},
        {R"("kind": "hinge", "motor": { "speed": 3 })",
         "/motor: \"torque\" is missing; add it: The most with which it turns, brakes and holds; what turns faster for "
         "another reason is braked by it."},
        {R"("kind": "hinge", "motor": { "speed": 3, "torque": 0 })", "/motor/torque: 0 must be above 0 [N m]"},
        {R"("kind": "hinge", "motor": { "speed": -3, "angle": 90, "torque": 10 })",
         "/motor/speed: must be above 0 beside an `angle`, which says which way to turn"},
        {R"("kind": "hinge", "motor": { "sped": 3, "angle": 90, "torque": 10 })",
         "/motor/sped: unknown field; did you mean \"speed\"?"},
        {R"("kind": "stiff", "spring": { "stiffness": 3 })",
         "/spring: turns a joint back; a stiff one does not turn; use a hinge, a ball or a universal joint"},
        {R"("kind": "hinge", "spring": {})",
         "/spring: neither pulls nor damps; give its `stiffness`, its `damping` or both"},
        {R"("kind": "hinge", "spring": { "stiffness": 0 })",
         "/spring: neither pulls nor damps; give it a `stiffness` or a `damping` above 0"},
        {R"("kind": "ball", "spring": { "stiffness": 3, "angle": 10 })",
         "/spring/angle: is of a hinge; a ball joint's spring turns it back to where it stood; leave it out"},
        {R"("kind": "hinge", "spring": { "stiffness": 3 }, "motor": { "speed": 3, "torque": 10 })",
         "/spring: is beside a `motor`; leave one of the two out"},
        {R"("kind": "hinge", "spring": { "stiffness": -3 })", "/spring/stiffness: -3 is below the minimum 0 [N m/rad]"},
    };
    for (const auto& entry : cases) {
        folder.write("joint.json", std::string(R"({ "objects": [
            { "type": "rigid", "shape": "box", "name": "door", "position": [0, 1, 0] },
            { "type": "joint", "bodies": ["door", "world"], "at": [0, 1, 0], )") +
                                       entry.joint + "} ] }");
        expectError(run({"check", "joint.json"}), 2, std::string("joint.json: /objects/1") + entry.message);
    }
}

/// Two cranks of the world with a rod between them: one of them may be driven, and both rod's ends.
TEST_F(SceneJoints, ALoopMayHaveAMotorButNotAtBothEnds)
{
    const auto check = [&](const char* left, const char* right, const char* settings) {
        folder.write("loop.json", std::string(R"({ "duration": 0.1, )") + settings + R"( "objects": [
            { "type": "rigid", "shape": "box", "name": "left", "size": [0.1, 0.5, 0.1], "position": [0, 1, 0] },
            { "type": "rigid", "shape": "box", "name": "right", "size": [0.1, 0.5, 0.1], "position": [1, 1, 0] },
            { "type": "rigid", "shape": "box", "name": "rod", "size": [1, 0.1, 0.1], "position": [0.5, 1.3, 0] },
            { "type": "joint", "kind": "hinge", "bodies": ["left", "world"], "at": [0, 0.8, 0])" +
                                      left + R"( },
            { "type": "joint", "kind": "hinge", "bodies": ["right", "world"], "at": [1, 0.8, 0])" +
                                      right + R"( },
            { "type": "joint", "kind": "hinge", "bodies": ["left", "rod"], "at": [0, 1.3, 0] },
            { "type": "joint", "kind": "hinge", "bodies": ["right", "rod"], "at": [1, 1.3, 0] } ] })");
        return run({"check", "loop.json"});
    };
    constexpr const char* MOTOR = R"(, "motor": { "speed": 3, "torque": 10 })";
    EXPECT_EQ(check(MOTOR, "", "").code, 0);
    EXPECT_EQ(check("", MOTOR, "").code, 0);
    expectError(check(MOTOR, MOTOR, ""), 2,
                "loop.json: the joint \"object_5\" closes a loop of joints with motors, springs, gears or limits, "
                "which cannot be; leave one joint of the loop without");
    expectError(
        check(MOTOR, "", R"("solver": "paper",)"), 2,
        "loop.json: the joint \"object_4\": the paper's solver has no motors; take it away, or use solver method "
        "impulse");
}

TEST_F(SceneJoints, TellWhatIsWrongWithTheirGears)
{
    const struct {
        const char* gear;
        const char* message;
    } cases[] = {
        {R"("joints": ["axle", "pinon"], "ratio": -2)", " /objects/4/joints/1: there is no object \"pinon\" of type "
                                                        "`joint` and kind `hinge`; did you mean \"pinion\"?"},
        {R"("joints": ["axle", "axle"], "ratio": -2)", " /objects/4/joints: names one hinge twice; a gear couples two"},
        {R"("joints": ["axle", "pinion"], "ratio": 0)",
         " /objects/4/ratio: must not be 0; for instance -1 for two equal wheels"},
        {R"("joints": ["axle", "pinion"], "ratio": -2 },
            { "type": "gear", "name": "other", "joints": ["pinion", "axle"], "ratio": -1)",
         " the gear \"other\" closes a ring that cannot turn: by it \"pinion\" has the ratio -1, by the others "
         "-2; take it away, or change its ratio"},
    };
    for (const auto& entry : cases) {
        folder.write("gear.json", std::string(R"({ "objects": [
            { "type": "rigid", "shape": "box", "name": "wheel", "size": [0.5, 0.5, 0.1], "position": [0, 1, 0] },
            { "type": "rigid", "shape": "box", "name": "small", "size": [0.3, 0.3, 0.1], "position": [0.5, 1, 0] },
            { "type": "joint", "kind": "hinge", "name": "axle", "bodies": ["wheel", "world"], "at": [0, 1, 0] },
            { "type": "joint", "kind": "hinge", "name": "pinion", "bodies": ["small", "world"], "at": [0.5, 1, 0] },
            { "type": "gear", )") + entry.gear +
                                      "} ] }");
        expectError(run({"check", "gear.json"}), 2, std::string("gear.json:") + entry.message);
    }
}

TEST_F(SceneJoints, AMotorOfAFixedBodyHasNothingToTurn)
{
    folder.write("fixed.json", R"({ "objects": [
        { "type": "rigid", "shape": "box", "name": "door", "position": [0, 1, 0], "fixed": true },
        { "type": "joint", "kind": "hinge", "bodies": ["door", "world"], "at": [0, 1, 0],
          "motor": { "speed": 3, "torque": 10 } } ] })");
    expectError(run({"check", "fixed.json"}), 2,
                "fixed.json: the joint \"object_2\": its motor has nothing to turn, since both bodies are fixed; free "
                "one of them");
}

}  // namespace
}  // namespace knuckle
