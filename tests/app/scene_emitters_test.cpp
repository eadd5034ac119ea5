#include <gtest/gtest.h>

#include <cmath>

#include "app/scene/scene_file.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

World load(const std::string& text)
{
    const test::TempFolder folder;
    return loadScene(folder.write("scene.json", text), {}).world;
}

TEST(SceneEmitters, APoolHasRoomForAllThatFlowsInTheFilm)
{
    const World world = load(R"({ "duration": 2, "emitters": [
        { "shape": "rectangle", "size": [0.2, 0.1], "speed": 1.5, "start": 0.5, "direction": [0, 0, -3] }] })");
    ASSERT_EQ(world.emitters.size(), 1u);
    const Emitter& emitter = world.emitters[0];
    ASSERT_EQ(emitter.nozzle.points.size(), 8u);
    EXPECT_NEAR(emitter.nozzle.layerSpacing, 0.05f, 1e-6f);
    EXPECT_LT((emitter.velocity - Vector3f(0, 0, -1.5f)).norm(), 1e-6f);
    // 30 layers a second for 1.5 s, and one at the start.
    EXPECT_EQ(emitter.pool, 8u * 46u);
    EXPECT_EQ(world.fluidCount, emitter.pool);
    EXPECT_EQ(world.pooledCount(), emitter.pool);
    EXPECT_EQ(world.particles.size(), emitter.pool);
    EXPECT_FLOAT_EQ(world.particles[0].mass, 0.125f);
}

TEST(SceneEmitters, APoolHasRoomForAllThatFlowsInFastMotion)
{
    const World world = load(R"({ "duration": 1, "shots": [{ "from": 0, "timeScale": 4 }], "emitters": [
        { "shape": "rectangle", "size": [0.2, 0.1], "speed": 1.5 }] })");
    // 30 layers a second for 59 frames of 4/60 s, and one at the start.
    EXPECT_EQ(world.emitters[0].pool, 8u * 119u);
}

TEST(SceneEmitters, PoolsStandBehindFluidsInTheOrderOfTheirEmitters)
{
    const World world = load(R"({ "materials": { "oil": { "fluid": true, "density": 800 } },
        "objects": [{ "type": "fluid", "shape": "box", "size": [0.1, 0.1, 0.1], "position": [3, 0, 0] },
                    { "type": "rigid", "shape": "box", "position": [0, 3, 0] }],
        "emitters": [{ "shape": "disc", "pool": 100, "material": "oil" }, { "shape": "disc", "pool": 50 }] })");
    EXPECT_EQ(world.solidCount(), 27u);
    EXPECT_EQ(world.fluidCount, 8u + 150u);
    for (size_t i = 27; i < world.particles.size(); ++i)
        EXPECT_FLOAT_EQ(world.particles[i].mass, i >= 35 && i < 135 ? 0.1f : 0.125f) << i;
}

TEST(SceneEmitters, ANozzlesLayersHoldAsMuchAsItsArea)
{
    for (const float radius : {0.04f, 0.1f, 0.33f}) {
        const World world = load(R"({ "emitters": [{ "shape": "disc", "radius": )" + std::to_string(radius) +
                                 R"(, "direction": [1, 1, 0] }] })");
        const Nozzle& nozzle = world.emitters[0].nozzle;
        const double volume = 3.14159265 * radius * radius * nozzle.layerSpacing;
        const double layer = static_cast<double>(nozzle.points.size()) * std::pow(world.fluidSpacing, 3.0);
        EXPECT_NEAR(layer, volume, 1e-4 * volume);
        for (const Vector3f& point : nozzle.points) {
            EXPECT_NEAR(point.dot(Vector3f(1, 1, 0)), 0.0f, 1e-5f);
            EXPECT_LT(point.norm(), radius + 0.5f * nozzle.pitch);
        }
    }
}

TEST(SceneDrains, AreRegionsOfTheWorld)
{
    const World world = load(R"({ "emitters": [{ "shape": "disc" }], "drains": [
        { "shape": "box", "size": [2, 4, 6], "position": [9, 0, 0] }, { "shape": "plane", "position": [0, -1, 0] },
        { "shape": "capsule", "radius": 0.25, "length": 3, "position": [0, 9, 0] }] })");
    ASSERT_EQ(world.drains.size(), 3u);
    EXPECT_EQ(world.drains[0].halfExtents, Vector3f(1, 2, 3));
    EXPECT_EQ(world.drains[1].shape, ColliderShape::Plane);
    EXPECT_EQ(world.drains[2].halfHeight, 1.5f);
    EXPECT_TRUE(world.colliders.empty());
}

}  // namespace
}  // namespace knuckle
