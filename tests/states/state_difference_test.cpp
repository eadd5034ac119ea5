#include <gtest/gtest.h>

#include "app/golden/golden_states.h"
#include "app/golden/state_difference.h"
#include "sim/base/no_index.h"

namespace knuckle::test {
namespace {

constexpr float RADIUS = 0.1f;

/// Two loose particles of sand, and a body of two.
Scene smallScene()
{
    Scene scene;
    World& world = scene.world;
    world.particleRadius = RADIUS;
    world.materials.resize(1);
    world.materials[0].name = "sand";
    world.particles.resize(4);
    world.particles[2].body = world.particles[3].body = 0;
    world.bodies.resize(1);
    world.bodies[0].object = 0;
    world.objects = {{"crate", 0, 1}};
    return scene;
}

ViewState stateOf(const World& world)
{
    ViewState view;
    for (size_t p = 0; p < world.particles.size(); ++p)
        view.positions.push_back({0.123456f * static_cast<float>(p), 0.3f, -0.7f, 0});
    view.velocities.assign(world.particles.size(), {1, 2, 3, 0});
    view.bodyCentres = {{0, 0, 0, 0}};
    view.bodyRotations = {{0, 0, 0, 1}};
    return view;
}

TEST(StateDifference, CountsWhatIsFurtherThanTheLimit)
{
    const Scene scene = smallScene();
    const ViewState stored = stateOf(scene.world);
    ViewState now = stored;
    now.positions[1].y += 0.01f;  // 0.05 diameters
    now.positions[3].x += 0.3f;   // 1.5 diameters
    const StateLimits limits{0.1, 0.0};
    const StateDifference difference = compareStates(scene.world, stored, now, limits);
    EXPECT_EQ(difference.moved, 1u);
    EXPECT_EQ(difference.farthest, 3u);
    EXPECT_NEAR(difference.largest, 1.5, 1e-5);
    EXPECT_NEAR(difference.mean, 1.55 / 4, 1e-5);
    EXPECT_EQ(difference.owner, "\"crate\"");
    EXPECT_EQ(differenceWords(difference, limits),
              "1 of 4 particles is more than 0.1 diameters from where they were, most of \"crate\" (1 of 2); the "
              "farthest, particle 3 of \"crate\", by 1.5 diameters, at 0.67 0.3 -0.7 m");
    EXPECT_FALSE(difference.isWithin(limits));
    EXPECT_TRUE(difference.isWithin({0.1, 0.25}));
    EXPECT_FALSE(difference.isWithin({0.1, 0.24}));
}

TEST(StateDifference, CountsWhatCameOrWent)
{
    const Scene scene = smallScene();
    const ViewState stored = stateOf(scene.world);
    ViewState now = stored;
    now.positions[0].w = 1.0f;
    const StateDifference difference = compareStates(scene.world, stored, now, {1e6, 0.0});
    EXPECT_EQ(difference.cameOrWent, 1u);
    EXPECT_EQ(difference.moved, 1u);
    EXPECT_EQ(difference.most, "\"sand\"");
    EXPECT_FALSE(difference.isWithin({1e6, 0.0}));
}

TEST(StateDifference, SeesColliders)
{
    const Scene scene = smallScene();
    ViewState stored = stateOf(scene.world);
    stored.colliderPlaces = {{0, 0, 0, 0}, {0, 0, 0, 1}};
    ViewState now = stored;
    now.colliderPlaces[0].x = 0.1f;
    const StateDifference difference = compareStates(scene.world, stored, now, {0.4, 0.0});
    EXPECT_NEAR(difference.colliders, 0.5, 1e-6);
    EXPECT_FALSE(difference.isWithin({0.4, 0.0}));
    EXPECT_TRUE(difference.isWithin({0.6, 0.0}));
}

TEST(StateDifference, OfOtherWorldsSaysSo)
{
    const Scene scene = smallScene();
    const ViewState now = stateOf(scene.world);
    ViewState stored = now;
    stored.positions.pop_back();
    const StateDifference difference = compareStates(scene.world, stored, now, {1e6, 1.0});
    EXPECT_FALSE(difference.isWithin({1e6, 1.0}));
    EXPECT_EQ(differenceWords(difference, {}), "it has 4 particles, the stored state 3");
}

TEST(CompactStates, RoundsLooseParticlesByLessThanIsTold)
{
    const Scene scene = smallScene();
    const ViewState exact = stateOf(scene.world);
    ViewState rounded = exact;
    compact(rounded, scene);
    // Steps of 1/256 of a diameter or less: half of one along each axis, over all three.
    const StateDifference difference = compareStates(scene.world, rounded, exact, {});
    EXPECT_GT(difference.largest, 0.0);
    EXPECT_LT(difference.largest, 0.5 / 256.0 * 1.7321);
    EXPECT_EQ(difference.moved, 0u);
    EXPECT_EQ(rounded.positions[3].x, exact.positions[3].x);
    EXPECT_EQ(rounded.velocities[0].x, 0.0f);
    Scene coloured = scene;
    coloured.render.colorBy = ColorBy::Speed;
    ViewState kept = exact;
    compact(kept, coloured);
    EXPECT_EQ(kept.velocities[0].x, 1.0f);
}

}  // namespace
}  // namespace knuckle::test
