#include <gtest/gtest.h>

#include <string>

#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

Scene load(const std::string& text)
{
    const test::TempFolder folder;
    return loadScene(folder.write("scene.json", text));
}

/// Level with a plane at rest that rubs alike, a floor may be that plane; else it ends at the outside of the walls.
TEST(Colliders, OfAContainerEndAtItsWalls)
{
    const std::string objects = R"({ "objects": [{ "type": "joined" }], "colliders": [{ "type": "plane" }, { )";
    const std::string container = R"("type": "container", "width": 4, "depth": 2, "height": 1, "thickness": 0.1)";
    const auto floorOf = [&](const std::string& more) {
        return load((objects + container + more + " }] }").c_str()).world.colliders.at(1);
    };
    EXPECT_EQ(floorOf("").shape, ColliderShape::Plane);
    EXPECT_FALSE(floorOf("").visible);
    for (const char* more : {R"(, "position": [0, 0.5, 0])", R"(, "rotation": [0, 0, 1])", R"(, "staticFriction": 0.9)",
                             R"(, "motion": { "keys": [{ "time": 0 }, { "time": 1, "position": [0, 1, 0] }] })"}) {
        const Collider floor = floorOf(more);
        EXPECT_EQ(floor.shape, ColliderShape::Box) << more;
        EXPECT_TRUE(floor.halfExtents.isApprox(Vector3f(2.1f, 0.05f, 1.1f))) << more;
    }
    EXPECT_NEAR(floorOf(R"(, "position": [0, 0.5, 0])").position.y(), 0.45f, 1e-6f);
    EXPECT_FALSE(floorOf(R"(, "staticFriction": 0.9)").visible);
}

TEST(Colliders, OfAGroupTurnTogetherAboutItsPivot)
{
    const Scene scene = load(R"({ "objects": [{ "type": "joined" }], "colliders": [
        { "type": "group", "position": [1, 2, 3], "rotation": [0, 90, 0], "pivot": [1, 0, 0],
          "motion": { "path": "linear", "keys": [{ "time": 0 }, { "time": 1, "rotation": [180, 0, 0] }] },
          "colliders": [{ "type": "sphere", "position": [0, 1, 0] },
                        { "type": "box", "size": [1, 1, 1], "position": [1, 0, 0] }] }] })");
    ASSERT_EQ(scene.world.colliderMotions.size(), 1u);
    // Turned by 90 degrees about y, x points to -z: the axis of the motion, through (1, 2, 2).
    const std::vector<Collider> before = collidersAt(scene.world, 0.0), later = collidersAt(scene.world, 0.5);
    EXPECT_TRUE(before[0].position.isApprox(Vector3f(1, 3, 3), 1e-4f)) << before[0].position.transpose();
    EXPECT_TRUE(before[1].position.isApprox(Vector3f(1, 2, 2), 1e-4f));
    EXPECT_TRUE(later[1].position.isApprox(Vector3f(1, 2, 2), 1e-4f));
    EXPECT_NEAR(std::abs(later[0].position.x() - 1.0f), 1.0f, 1e-3f);
    EXPECT_NEAR(later[0].position.y(), 2.0f, 1e-3f);
}

TEST(Colliders, OfAGroupAreRefusedByTheirOwnPaths)
{
    const auto messageOf = [](const std::string& part, const std::string& more) -> std::string {
        try {
            load(R"({ "colliders": [{ "type": "group", "position": [0, 1, 0], "colliders": [)" + part + "] }], " +
                 more + " }");
        } catch (const InputError& error) {
            const std::string text = error.what();
            return text.substr(text.find(": ") + 2);
        }
        return "";
    };
    const std::string joined = R"("objects": [{ "type": "joined" }])";
    EXPECT_EQ(messageOf(R"({ "type": "sphere", "motion": { "keys": [{ "time": 0 }] } })", joined),
              "/colliders/0/colliders/0/motion: parts of a group move together; give it to the group");
    EXPECT_EQ(messageOf("", joined), "/colliders/0/colliders: is an array of 0, must be at least 1");
    EXPECT_EQ(messageOf(R"({ "type": "sphere", "position": [5, 0, 0] },
                            { "type": "box", "size": [1, 1, 1], "position": [0, -1, 0] })",
                        R"("emitters": [{ "shape": "disc" }])"),
              "/emitters/0/position: the nozzle is inside or against /colliders/0/colliders/1; keep it at least half a "
              "rest distance, 0.025 m, away");
}

}  // namespace
}  // namespace knuckle
