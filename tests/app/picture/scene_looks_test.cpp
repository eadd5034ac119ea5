#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

/// A scene of one box with `fields` added at the top.
Scene sceneWith(const TempFolder& folder, const std::string& fields)
{
    return loadScene(
        folder.write("scene.json", R"({ "objects": [{ "type": "rigid", "shape": "box" }], )" + fields + "}"));
}

std::string problemOf(const std::string& fields)
{
    const TempFolder folder;
    const std::string message = messageOf<InputError>([&] { sceneWith(folder, fields); });
    const std::string file = folder.path("scene.json");
    return message.starts_with(file) ? message.substr(file.size()) : message;
}

TEST(SceneLooks, ReadsFinishesAndWhatDiffersFromThem)
{
    const TempFolder folder;
    const World world = sceneWith(folder, R"("materials": { "default": { "finish": "wax", "roughness": 0.2 } },
        "colliders": [{ "type": "plane", "floor": "tiles" },
                      { "type": "sphere", "finish": "metal", "metalness": 0.5 }])")
                            .world;
    EXPECT_EQ(world.materials[0].finish, (SurfaceFinish{Finish::Wax, 0.2f, -1.0f}));
    EXPECT_EQ(world.colliders[0].floor, FloorLook::Tiles);
    EXPECT_EQ(world.colliders[0].finish, SurfaceFinish());
    EXPECT_EQ(world.colliders[1].finish, (SurfaceFinish{Finish::Metal, -1.0f, 0.5f}));
}

TEST(SceneLooks, ReadsWhatSendsOutLight)
{
    const TempFolder folder;
    const World world = sceneWith(folder, R"("materials": { "default": { "finish": "glass", "emission": 2 },
        "lava": { "fluid": true, "emission": 3 } }, "colliders": [{ "type": "sphere", "emission": 4 }])")
                            .world;
    EXPECT_EQ(world.materials[0].finish, (SurfaceFinish{Finish::Glass, -1.0f, -1.0f, 2.0f}));
    EXPECT_EQ(world.materials[1].look.emission, 3.0f);
    EXPECT_EQ(world.materials[1].finish, SurfaceFinish());
    EXPECT_EQ(world.colliders[0].finish.emission, 4.0f);
}

TEST(SceneLooks, ReadsLights)
{
    const TempFolder folder;
    const RenderSettings render = sceneWith(folder, R"("lights": [
        { "type": "point", "position": [1, 2, 3], "color": [1, 0, 0], "intensity": 7 },
        { "type": "directional", "direction": [0, 1, 0] }], "light": { "color": [0.5, 0.6, 0.7] },
        "render": { "toneMap": "agx", "background": [0.1, 0.2, 0.3] })")
                                      .render;
    ASSERT_EQ(render.lights.size(), 2u);
    EXPECT_TRUE(render.lights[0].isPoint);
    EXPECT_EQ(render.lights[0].place, Eigen::Vector3f(1, 2, 3));
    EXPECT_EQ(render.lights[0].intensity, 7.0f);
    EXPECT_FALSE(render.lights[1].isPoint);
    EXPECT_EQ(render.light.color, Eigen::Vector3f(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(render.toneMap, ToneMap::Agx);
    EXPECT_EQ(render.background, Background::Color);
    EXPECT_EQ(render.backgroundColor, Eigen::Vector3f(0.1f, 0.2f, 0.3f));
}

TEST(SceneLooks, SkyGivesColorsUnlessTheSceneDoes)
{
    const TempFolder folder;
    const LightSettings plain = sceneWith(folder, R"("light": {})").render.light;
    EXPECT_EQ(plain.sky, nullptr);
    EXPECT_EQ(plain.skyColor, LightSettings().skyColor);
    const LightSettings clear =
        sceneWith(folder, R"("light": { "sky": "clear", "groundColor": [1, 2, 3] })").render.light;
    ASSERT_NE(clear.sky, nullptr);
    EXPECT_EQ(clear.skyColor, clear.sky->meanOf(true));
    EXPECT_EQ(clear.groundColor, Eigen::Vector3f(1, 2, 3));
    EXPECT_GT(clear.skyColor.z(), clear.skyColor.x()) << "the sky is blue";
    EXPECT_NE(clear.color, LightSettings().color);
    folder.write("sky.png", "not yet read");
    const LightSettings picture =
        sceneWith(folder, R"("light": { "sky": "sky.png", "skyColor": [1, 1, 1] })").render.light;
    EXPECT_EQ(picture.skyFile, folder.path("sky.png"));
    EXPECT_TRUE(picture.takesGroundColor);
    EXPECT_FALSE(picture.takesSkyColor);
}

TEST(SceneLooks, MistakesAreTold)
{
    EXPECT_EQ(problemOf(R"("materials": { "a": { "finish": "wod" } })"),
              ": /materials/a/finish: \"wod\" is unknown; did you mean \"wood\"?");
    EXPECT_EQ(
        problemOf(R"("materials": { "a": { "fluid": true, "finish": "wax" } })"),
        ": /materials/a/finish: is for what is solid; a fluid looks as `color`, `absorption` and `scattering` say");
    EXPECT_EQ(problemOf(R"("materials": { "a": { "roughness": 2 } })"),
              ": /materials/a/roughness: 2 is above the maximum 1");
    EXPECT_EQ(
        problemOf(R"("colliders": [{ "type": "plane", "floor": "lawn" }])"),
        ": /colliders/0/floor: \"lawn\" is unknown; known: default, studio, tiles, checker, wood, grass, grid, mirror, "
        "none");
    EXPECT_EQ(problemOf(R"("light": { "sky": "clear", "direction": [1, -0.1, 0] })"),
              ": /light/direction: has a sun below the horizon, and the sky is \"clear\"; give it a y above 0");
    EXPECT_EQ(problemOf(R"("light": { "sky": "clear", "turbidity": 1 })"),
              ": /light/turbidity: 1 is below the minimum 2");
    EXPECT_EQ(problemOf(R"("light": { "sky": "claer" })"),
              ": /light/sky: \"claer\" is unknown; did you mean \"clear\"?");
    EXPECT_EQ(problemOf(R"("render": { "toneMap": "flim" })"),
              ": /render/toneMap: \"flim\" is unknown; did you mean \"film\"?");
    EXPECT_EQ(problemOf(R"("lights": [{ "type": "directional", "direction": [0, 0, 0] }])"),
              ": /lights/0/direction: must not be zero");
    EXPECT_EQ(problemOf(R"("lights": [{"type": "point"}, {"type": "point"}, {"type": "point"}, {"type": "point"},
        {"type": "point"}])"),
              ": /lights: is an array of 5, must be at most 4");
    EXPECT_NE(problemOf(R"("light": { "sky": "there_is_none.png" })").find(": /light/sky: there is no file "),
              std::string::npos);
}

}  // namespace
}  // namespace knuckle::test
