#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

class SceneForces : public testing::Test {
protected:
    World load(const std::string& forces)
    {
        const std::string box = R"("objects": [{ "type": "rigid", "shape": "box", "size": [0.2, 0.2, 0.2] }])";
        return loadScene(folder.write("scene.json", "{" + forces + ", " + box + "}")).world;
    }
    std::string errorOf(const std::string& forces)
    {
        const std::string message = test::messageOf<InputError>([&] { load(forces); });
        return message.substr(message.find(": ") + 2);
    }

    test::TempFolder folder;
};

TEST_F(SceneForces, AreAsWritten)
{
    const World world = load(R"("wind": { "velocity": [3, 0, -4], "density": 1.5, "gusts": 0.2, "gustSize": 0.7,
        "seed": 9 }, "fields": [
        { "shape": "capsule", "kind": "swirl", "radius": 2, "length": 3, "position": [1, 2, 3],
          "rotation": [0, 0, 90], "strength": 7, "falloff": "inverseSquare", "start": 0.5, "stop": 2 },
        { "shape": "plane", "kind": "push" }])");
    EXPECT_EQ(world.wind->velocity, Vector3f(3, 0, -4));
    EXPECT_EQ(world.wind->density, 1.5f);
    EXPECT_EQ(world.wind->gusts, 0.2f);
    EXPECT_EQ(world.wind->gustSize, 0.7f);
    EXPECT_EQ(world.wind->seed, 9u);
    ASSERT_EQ(world.forceFields.size(), 2u);
    const ForceField& swirl = world.forceFields[0];
    EXPECT_EQ(swirl.kind, FieldKind::Swirl);
    EXPECT_EQ(swirl.falloff, FieldFalloff::InverseSquare);
    EXPECT_EQ(swirl.region.shape, ColliderShape::Capsule);
    EXPECT_EQ(swirl.region.radius, 2.0f);
    EXPECT_EQ(swirl.region.halfHeight, 1.5f);
    EXPECT_LT((swirl.region.orientation * Vector3f::UnitY() + Vector3f::UnitX()).norm(), 1e-5f);
    EXPECT_EQ(swirl.strength, 7.0f);
    EXPECT_EQ(swirl.start, 0.5f);
    EXPECT_EQ(swirl.stop, 2.0f);
    EXPECT_EQ(world.forceFields[1].stop, std::numeric_limits<float>::infinity());
}

TEST_F(SceneForces, AirIsThereWhereItIsAskedForOrBlown)
{
    EXPECT_FALSE(load(R"("name": "none")").wind);
    EXPECT_EQ(load(R"("wind": {})").wind->velocity, Vector3f(0, 0, 0));
    EXPECT_FALSE(load(R"("fields": [{ "shape": "sphere", "kind": "pull" }])").wind);
    EXPECT_TRUE(load(R"("fields": [{ "shape": "sphere", "kind": "blow" }])").wind);
}

TEST_F(SceneForces, AreRefusedWhereTheyMeanNothing)
{
    EXPECT_EQ(errorOf(R"("fields": [{ "shape": "sphere", "kind": "push", "start": 2, "stop": 1 }])"),
              "/fields/0/stop: 1 s is not after start, 2 s; raise it or lower the other");
    EXPECT_EQ(errorOf(R"("fields": [{ "shape": "plane", "kind": "push", "falloff": "linear" }])"),
              "/fields/0/falloff: \"linear\" is unknown; known: none");
    EXPECT_EQ(errorOf(R"("fields": [{ "shape": "sphere" }])"),
              "/fields/0: \"kind\" is missing; known: pull, push, swirl, blow");
    EXPECT_EQ(errorOf(R"("wind": { "gusts": 3 })"), "/wind/gusts: 3 is above the maximum 2");
    EXPECT_EQ(errorOf(R"("wind": {}, "solver": "paper")"),
              "wind and fields are for the method \"impulse\"; take the preset \"paper\" away, or them");
}

}  // namespace
}  // namespace knuckle
