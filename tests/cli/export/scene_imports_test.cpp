#include <gtest/gtest.h>

#include <fmt/format.h>

#include "app/export/rig.h"
#include "app/scene/scene_file.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// Five objects of one file: limp, animated by its own clip, by one of "another" file, in its skin, and as five copies.
std::string fiveFigures()
{
    const std::string file = test::inSource("assets/models/humanoid.glb");
    std::string objects;
    for (const char* more : {R"()", R"(, "animation": { "clip": "walk" })", R"(, "skin": "mesh")",
                             R"(, "pose": { "clip": "walk", "time": 0.2 }, "skin": "both")",
                             R"(, "repeat": { "counts": [5, 1, 1], "spacing": [1, 1, 1] })"})
        objects += fmt::format(R"({}{{ "type": "actor", "file": "{}", "position": [0, {}, 0]{} }})",
                               objects.empty() ? "" : ", ", file, objects.size(), more);
    return R"({ "diameter": 0.06, "objects": [)" + objects + "]}";
}

TEST(SceneImports, AModelIsReadOnceHoweverManyWearAndPlayIt)
{
    test::TempFolder folder;
    const Scene scene = loadScene(folder.write("scene.json", fiveFigures()));
    EXPECT_EQ(scene.imports->count(), 1u);
    EXPECT_EQ(rigsOf(scene, true).size(), 9u);
    EXPECT_EQ(rigsOf(scene, false).size(), 9u);
    EXPECT_EQ(scene.imports->count(), 1u) << "exports take what the scene has";
}

TEST(SceneImports, ExportsThatDrawSaySoBeforeTheSceneIsRead)
{
    test::TempFolder folder;
    const std::string path = folder.write("scene.json",
                                          R"({ "diameter": 0.06, "objects": [{ "type": "actor", "file": ")" +
                                              test::inSource("assets/models/humanoid.glb") + R"(" }] })");
    const Scene scene = loadScene(path, {}, true);
    EXPECT_FALSE(rigsOf(scene, true).front().model.surface.vertices.empty());
    EXPECT_EQ(scene.imports->count(), 1u);
}

}  // namespace
}  // namespace knuckle
