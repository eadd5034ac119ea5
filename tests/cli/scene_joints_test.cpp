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

}  // namespace
}  // namespace knuckle
