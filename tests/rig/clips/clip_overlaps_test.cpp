#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/clip_overlaps.h"
#include "sim/rig/clips/clip_ranges.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle::test {

namespace {

constexpr uint32_t KEYS = 10;

Actor figure()
{
    ActorOptions options;
    options.voxels.diameter = 0.05f;
    return makeActor(makeHumanoid(), options);
}

uint32_t bodyNamed(const Actor& actor, const std::string& name)
{
    return static_cast<uint32_t>(std::ranges::find(actor.bodies, name, &ActorBody::name) - actor.bodies.begin());
}

/// The figure stands still, except that some of the first keys turn its left arm back through its chest.
BodyClip throughTheChest(const Actor& actor, uint32_t keys)
{
    BodyClip clip{.name = "still", .rate = 30.0f, .bodyCount = static_cast<uint32_t>(actor.bodies.size())};
    clip.roots.assign(KEYS, pivotOf(actor));
    clip.turns.assign(size_t{KEYS} * clip.bodyCount, Quaternionf::Identity());
    for (uint32_t k = 0; k < keys; ++k)
        clip.turns[size_t{k} * clip.bodyCount + bodyNamed(actor, "upper_arm.L")] = Eigen::AngleAxisf(
            std::numbers::pi_v<float>, Vector3f::UnitY());
    return clip;
}

}  // namespace

TEST(ClipOverlaps, BodiesThatLieInEachOtherInMostOfAClipNeverTouch)
{
    Actor actor = figure();
    const uint32_t arm = bodyNamed(actor, "forearm.L"), chest = bodyNamed(actor, "chest");
    ASSERT_FALSE(neverTouch(actor, arm, chest));
    allow(actor, needsOf(actor, throughTheChest(actor, KEYS / 2 + 1)));
    EXPECT_TRUE(neverTouch(actor, arm, chest));
    // Its shins are as far from each other as before, and a shin and its thigh have limits already.
    EXPECT_FALSE(neverTouch(actor, bodyNamed(actor, "shin.L"), bodyNamed(actor, "shin.R")));
    for (const auto& [a, b] : actor.filtered) {
        EXPECT_LT(a, b);
        EXPECT_NE(parentBody(actor, b), static_cast<int32_t>(a));
    }
    const size_t found = actor.filtered.size();
    allow(actor, needsOf(actor, throughTheChest(actor, KEYS)));
    EXPECT_EQ(actor.filtered.size(), found) << "a pair is named twice";

    WorldBuilder builder(actor.diameter / 2);
    const uint32_t object = addActor(builder, actor, builder.addMaterial({}), {});
    const World world = builder.build();
    const uint32_t first = world.objects[object].bodyStart;
    EXPECT_TRUE(areFiltered(world, first + arm, first + chest) && areFiltered(world, first + chest, first + arm));
}

TEST(ClipOverlaps, BodiesThatLieInEachOtherNowAndThenTouch)
{
    const Actor actor = figure();
    EXPECT_TRUE(overlapsIn(actor, throughTheChest(actor, KEYS / 2)).empty());
    EXPECT_TRUE(overlapsIn(actor, throughTheChest(actor, 0)).empty());
}

}  // namespace knuckle::test
