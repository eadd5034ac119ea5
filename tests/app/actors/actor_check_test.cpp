#include "app/files/actor_check.h"

#include <gtest/gtest.h>

#include "app/files/actor_file.h"
#include "app/json/json.h"
#include "sim/base/errors.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// The example of docs/actor-format.md.
std::string door()
{
    const std::string page = test::readText(test::inSource("docs/actor-format.md"));
    const size_t start = page.find("```json\n") + 8;
    return page.substr(start, page.find("```", start) - start);
}

class ActorCheck : public testing::Test {
protected:
    /// Writes the door with other words in one place. @returns the file's path.
    std::string changed(const std::string& from, const std::string& to) const
    {
        std::string text = door();
        const size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return folder.write("door.json", text.replace(at, from.size(), to));
    }
    /// What is said of such a file.
    std::string faultOf(const std::string& from, const std::string& to) const
    {
        const std::string path = changed(from, to);
        try {
            worldOf(path, readActor(path));
        } catch (const InputError& error) {
            return std::string(error.what()).substr(path.size() + 2);
        }
        return "fine";
    }
    std::vector<std::string> warningsOf(const std::string& from, const std::string& to) const
    {
        const Actor actor = readActor(changed(from, to));
        return actorWarnings(actor, worldOf("door", actor));
    }
    test::TempFolder folder;
};

TEST_F(ActorCheck, TheExampleOfTheFormatIsWhatThePageSays)
{
    EXPECT_TRUE(warningsOf("door", "door").empty());
    const Actor actor = readActor(folder.path("door.json"));
    const World world = worldOf("door", actor);
    ASSERT_EQ(world.bodies.size(), 2u);
    // Four particles of 1 kg, and half of two: 4 * -0.1 m / 5, and (2 * 0.1 m + 2 * 0.2 m) / 5.
    EXPECT_NEAR(world.bodies[0].mass, 5.0f, 1e-5f);
    EXPECT_NEAR(world.bodies[1].mass, 5.0f, 1e-5f);
    EXPECT_NEAR(world.bodies[0].position.x(), -0.08f, 1e-6f);
    EXPECT_NEAR(world.bodies[1].position.x(), 0.12f, 1e-6f);
    EXPECT_EQ(world.joints.at(0).type, JointType::Hinge);
}

TEST_F(ActorCheck, TellsOfParticlesAtOnePlaceInNoBodyOrTwice)
{
    EXPECT_EQ(faultOf("[0.2, 0.1, 0]", "[0.2, 0.0099, 0]"),
              "/particles/9: is 0.0099 m from particle 8, nearer than a tenth of the diameter, 0.1 m; remove one, or "
              "let bodies share it");
    EXPECT_EQ(faultOf("[0.2, 0.1, 0]", "[0.2, 0.0101, 0]"), "fine");
    EXPECT_EQ(faultOf("[-0.1, 0, 0]", "[0.0000001, 0.1, -0.0000001]").substr(0, 20), "/particles/5: is 1.4");
    EXPECT_EQ(faultOf("7, 8, 9]", "7, 8]"), "/particles/9: belongs to no body; remove it");
    EXPECT_EQ(faultOf("7, 8, 9]", "7, 8, 9, 10]"), "/bodies/1/particles/6: 10 is not one of the 10 particles");
    EXPECT_EQ(faultOf("7, 8, 9]", "7, 8, 9, 8]"),
              "/bodies/1/particles/6: particle 8 is in this list already; remove it");
}

TEST_F(ActorCheck, TellsOfBodiesWithoutParticles)
{
    EXPECT_EQ(faultOf("[4, 5, 6, 7, 8, 9]", "[]"), "/bodies/1/particles: is an array of 0, must be at least 1");
    // Of two with the same particles the first has them.
    EXPECT_EQ(faultOf("[4, 5, 6, 7, 8, 9] }",
                      "[4, 5, 6, 7, 8, 9] }, { \"name\": \"copy\", \"particles\": [4, 5, 6, 7, 8, 9] }"),
              "/bodies/2/particles: other bodies share all of them; add one that is the body's own");
}

TEST_F(ActorCheck, TellsOfJointsThatHoldNothing)
{
    EXPECT_EQ(faultOf("\"sharedParticles\": [4, 5]", "\"sharedParticles\": [4, 6]"),
              "/joints/0/sharedParticles/1: particle 6 is not in body 0 (\"post\"), so it does not hold it; add it to "
              "/bodies/0/particles, or name one of both bodies");
    EXPECT_EQ(faultOf("[4, 5, 6, 7, 8, 9]", "[6, 7, 8, 9]"),
              "/joints/0/sharedParticles/0: particle 4 is not in body 1 (\"door\"), so it does not hold it; add it to "
              "/bodies/1/particles, or name one of both bodies");
    EXPECT_EQ(faultOf("\"parent\": 0, \"child\": 1", "\"parent\": 1, \"child\": 1"),
              "/joints/0/child: 1 is the parent, too; name another body");
    EXPECT_EQ(faultOf("\"child\": 1", "\"child\": 2"), "/joints/0/child: 2 is not one of the 2 bodies");
    EXPECT_EQ(faultOf("\"parent\": 0, \"particles\"", "\"particles\""),
              "/bodies/1/parent: is -1, but joint 0 with limits hangs the body on 0; make both the same, or leave the "
              "limits out");
    EXPECT_EQ(faultOf("\"axis\": [0, 1, 0]", "\"axis\": [0, 0, 0]"),
              "/joints/0/axis: must not be zero, since limits are angles about it");
    EXPECT_EQ(faultOf("[0, 110]", "[10, 110]"),
              "the joint of \"post\" and \"door\": the turn from 10 to 110 degrees must be within -180 to 180 and "
              "contain 0, the rest pose");
}

TEST_F(ActorCheck, TellsOfNumbersThatAreNone)
{
    EXPECT_EQ(faultOf("[0.2, 0.1, 0]", "[0.2, null, 0]"), "/particles/9/1: is null, must be a number");
    EXPECT_EQ(faultOf("[0.2, 0.1, 0]", "[0.2, 1e39, 0]").substr(0, 17), "/particles/9/1: 1");
    EXPECT_NE(faultOf("[0.2, 0.1, 0]", "[0.2, 1e999, 0]"), "fine");
    EXPECT_NE(faultOf("[0.2, 0.1, 0]", "[0.2, NaN, 0]"), "fine");
}

TEST_F(ActorCheck, WarnsOfJointsThatTurnOtherwiseThanTheySay)
{
    EXPECT_EQ(warningsOf("\"hinge\", \"parent\": 0, \"child\": 1, \"anchor\": [0, 0.05, 0], \"axis\": [0, 1, 0],\n"
                         "      \"sharedParticles\": [4, 5], \"limits\": { \"bend\": [0, 110] } }",
                         "\"ball\", \"parent\": 0, \"child\": 1, \"sharedParticles\": [4] }"),
              (std::vector<std::string>{"/joints/0/type: the bodies share particles in a line, which makes a hinge "
                                        "joint, not a ball one; that shares particles at one place"}));
    EXPECT_EQ(warningsOf("\"axis\": [0, 1, 0]", "\"axis\": [0.6, 0.8, 0]"),
              (std::vector<std::string>{"/joints/0/axis: the hinge turns about the line of its particles, (0.00 1.00 "
                                        "0.00), not about this; make it the same"}));
    EXPECT_TRUE(warningsOf("\"axis\": [0, 1, 0]", "\"axis\": [0, -1, 0]").empty());
}

TEST_F(ActorCheck, BodiesOfOneNameAreTold)
{
    EXPECT_EQ(warningsOf("\"name\": \"post\"", "\"name\": \"door\""),
              std::vector<std::string>{"/bodies/1/name: body 0 is \"door\", too, so a scene cannot name one of them "
                                       "alone; rename one"});
}

TEST_F(ActorCheck, TellsOfPairsThatAreNone)
{
    const auto pairs = [&](const std::string& text) {
        return faultOf("\"joints\":", "\"neverTouch\": " + text + ",\n  \"joints\":");
    };
    EXPECT_EQ(pairs("[[0, 2]]"), "/neverTouch/0/1: 2 is not one of the 2 bodies");
    EXPECT_EQ(pairs("[[1, 1]]"), "/neverTouch/0: names body 1 twice; name another one, or remove the pair");
    EXPECT_EQ(pairs("[[1, 0], [0, 1]]"), "/neverTouch/1: is the pair of /neverTouch/0 again; remove one");
    EXPECT_EQ(pairs("[[0, 1, 1]]"), "/neverTouch/0: is an array of 3, must be an array of 2 integers");
    EXPECT_EQ(pairs("[0]"), "/neverTouch/0: is 0 (a number), must be an array of 2 integers");
    EXPECT_EQ(pairs("[[1, 0]]"), "fine");
    EXPECT_TRUE(areFiltered(worldOf("door", readActor(folder.path("door.json"))), 0, 1)) << "in either order";
}

TEST_F(ActorCheck, KnowsActorsByTheirContent)
{
    EXPECT_TRUE(isActorFile(changed("door", "door")));
    EXPECT_FALSE(isActorFile(changed("\"format\": \"knuckle-actor\",", "")));
    EXPECT_FALSE(isActorFile(folder.write("list.json", "[1]")));
    EXPECT_FALSE(isActorFile(folder.write("number.json", "{ \"format\": 1 }")));
    EXPECT_FALSE(isActorFile(folder.path("none.json")));
}

}  // namespace
}  // namespace knuckle
