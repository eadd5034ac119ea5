#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/scene/scene_file.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

World load(const std::string& object)
{
    const test::TempFolder folder;
    const std::string path = folder.write("scene.json", R"({ "objects": [{ "type": "grains", )" + object + " }] }");
    return loadScene(path, {}).world;
}

TEST(SceneGrains, FillABoxAtOneDiameter)
{
    const World world = load(R"("shape": "box", "size": [0.5, 0.3, 0.2], "position": [1, 2, 3], "velocity": [0, -1, 0],
                "jitter": 0)");
    ASSERT_EQ(world.particles.size(), 5u * 3u * 2u);
    EXPECT_TRUE(world.bodies.empty());
    Vector3f middle = Vector3f::Zero();
    for (const Particle& p : world.particles) {
        middle += p.position / static_cast<float>(world.particles.size());
        EXPECT_EQ(p.body, NO_INDEX);
        EXPECT_FLOAT_EQ(p.mass, 1.0f);  // 1000 kg/m3 times 0.1 m cubed
        EXPECT_EQ(p.velocity, Vector3f(0, -1, 0));
    }
    EXPECT_LT((middle - Vector3f(1, 2, 3)).norm(), 1e-5f);
}

TEST(SceneGrains, TheScenesSeedIsAddedToTheirs)
{
    const test::TempFolder folder;
    const auto first = [&](int own, int scene) {
        const std::string path = folder.write("scene.json", R"({ "seed": )" + std::to_string(scene) +
                                                                R"(, "objects": [{ "type": "grains", "shape": "box",
            "seed": )" + std::to_string(own) + " }] }");
        return loadScene(path, {}).world.particles[0].position;
    };
    EXPECT_EQ(first(2, 3), first(5, 0));
    EXPECT_NE(first(2, 3), first(2, 0));
}

TEST(SceneGrains, AreAsFarApartAsTheSpacingSays)
{
    EXPECT_EQ(load(R"("shape": "box", "size": [0.5, 0.3, 0.2], "spacing": 0.25)").particles.size(), 2u);
}

TEST(SceneGrains, FillEveryShapeWithAboutItsVolume)
{
    // Volume over the lattice's; the surface cuts off less than a third of a lattice of ten an axis.
    EXPECT_NEAR(static_cast<double>(load(R"("shape": "sphere", "radius": 0.5)").particles.size()), 524.0, 175.0);
    EXPECT_NEAR(static_cast<double>(load(R"("shape": "capsule", "radius": 0.5, "length": 1)").particles.size()), 1309.0,
                440.0);
    EXPECT_NEAR(static_cast<double>(load(R"("shape": "cone", "radius": 1, "height": 1)").particles.size()), 1047.0,
                350.0);
}

TEST(SceneGrains, AConeStandsOnItsBase)
{
    float low = 1, high = 0;
    for (const Particle& p : load(R"("shape": "cone", "radius": 1, "height": 1, "jitter": 0)").particles) {
        low = std::min(low, p.position.y());
        high = std::max(high, p.position.y());
        EXPECT_LE(std::hypot(p.position.x(), p.position.z()), 1.0f - p.position.y() + 1e-3f);
    }
    EXPECT_FLOAT_EQ(low, 0.05f);
    EXPECT_FLOAT_EQ(high, 0.95f);
}

TEST(SceneGrains, NoLayerStandsOnTheOneBelow)
{
    const World world = load(R"("shape": "box", "size": [0.1, 1, 0.1], "jitter": 1e-6)");
    for (size_t i = 1; i < world.particles.size(); ++i) {
        const Vector3f step = world.particles[i].position - world.particles[i - 1].position;
        EXPECT_NEAR(std::hypot(step.x(), step.z()), std::sqrt(2.0) * 0.025, 1e-5) << i;
    }
}

TEST(SceneGrains, JitterIsBoundedAndTheSameForOneSeed)
{
    const std::string box = R"("shape": "box", "size": [1, 1, 1])";
    const World still = load(box + R"(, "jitter": 1e-6)"), first = load(box + R"(, "jitter": 0.2, "seed": 7)"),
                again = load(box + R"(, "jitter": 0.2, "seed": 7)"),
                other = load(box + R"(, "jitter": 0.2, "seed": 8)");
    float most = 0.0f;
    for (size_t i = 0; i < still.particles.size(); ++i) {
        const Vector3f shift = first.particles[i].position - still.particles[i].position;
        most = std::max(most, shift.cwiseAbs().maxCoeff());
        EXPECT_EQ(first.particles[i].position, again.particles[i].position);
    }
    EXPECT_LE(most, 0.02f + 1e-6f);
    EXPECT_GT(most, 0.019f);
    EXPECT_NE(first.particles[0].position, other.particles[0].position);
}

}  // namespace
}  // namespace knuckle
