#include "sim/rig/bodies/resolution.h"

#include <cmath>
#include <numbers>

#include "sim/base/errors.h"
#include "tests/rig/actor_fixture.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle {
namespace {

constexpr float LENGTH = 0.3f;

/// A figure of tubes, one a bone, each hanging on the last.
Model tubes(const std::vector<std::pair<std::string, float>>& namesAndRadii)
{
    constexpr uint32_t SIDES = 48, RINGS = 30;
    Model model;
    for (uint32_t b = 0; b < namesAndRadii.size(); ++b) {
        Bone bone{namesAndRadii[b].first, static_cast<int32_t>(b) - 1};
        bone.restPose(1, 3) = -LENGTH * static_cast<float>(b);
        model.bones.push_back(bone);
        const auto first = static_cast<uint32_t>(model.vertices.size());
        for (uint32_t r = 0; r <= RINGS; ++r) {
            for (uint32_t s = 0; s < SIDES; ++s) {
                const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(s) / SIDES;
                const float y = bone.restPose(1, 3) - LENGTH * static_cast<float>(r) / RINGS;
                const float radius = namesAndRadii[b].second;
                // Beside its bone, since bones are seldom in the middle of their skin.
                model.vertices.push_back({0.01f + radius * std::cos(turn), y, radius * std::sin(turn)});
                SkinWeights skin;
                skin.bones[0] = b;
                skin.weights[0] = 1.0f;
                model.skin.push_back(skin);
            }
        }
        for (uint32_t r = 0; r < RINGS; ++r) {
            for (uint32_t s = 0; s < SIDES; ++s) {
                const uint32_t a = first + r * SIDES + s, next = first + r * SIDES + (s + 1) % SIDES;
                model.triangles.push_back({a, next, next + SIDES});
                model.triangles.push_back({a, next + SIDES, a + SIDES});
            }
        }
    }
    return model;
}

Model arm()
{
    return tubes({{"spine", 0.25f}, {"LeftArm", 0.06f}, {"LeftForeArm", 0.05f}, {"LeftHand", 0.02f}, {"tip", 0.01f}});
}

std::vector<LimbThickness> thicknesses(const Model& model)
{
    return limbThicknesses(readFigure(model));
}

TEST(Resolution, aTubeIsAsThickAsItsDiameter)
{
    const std::vector<LimbThickness> limbs = thicknesses(arm());
    ASSERT_EQ(limbs.size(), 2u) << "upper arm and forearm; a hand may be thinner";
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(limbs[i].bone, i + 1);
        // Middles of the triangles of a polygon of 48 sides are within 0.3 % of the circle.
        EXPECT_NEAR(limbs[i].thickness, i == 0 ? 0.12f : 0.1f, 0.001f);
        EXPECT_NEAR(limbs[i].length, LENGTH, 1e-6f);
    }
    EXPECT_NEAR(limbDiameter(thicknesses(arm())), 0.04f, 0.0004f) << "two and a half particles across the forearm";
}

TEST(Resolution, whereNoLimbIsKnownEveryLongBoneIsOne)
{
    const Model model = tubes({{"a", 0.2f}, {"b", 0.08f}, {"c", 0.06f}, {"d", 0.05f}});
    const std::vector<LimbThickness> limbs = thicknesses(model);
    ASSERT_EQ(limbs.size(), 2u) << "the first is thicker than long, the last ends nowhere";
    EXPECT_NEAR(limbDiameter(limbs), 0.12f / 2.5f, 0.0005f);
}

TEST(Resolution, aModelWithoutASkeletonHasNoLimbs)
{
    Model model = arm();
    model.bones.clear();
    model.skin.clear();
    EXPECT_TRUE(thicknesses(model).empty());
    EXPECT_EQ(limbDiameter({}), 0.0f);
}

TEST(MakeActor, limbsDecideTheDiameterAsFarAsTheCountAllows)
{
    EXPECT_NEAR(makeActor(arm(), {}).diameter, 0.04f, 0.0004f);
    // A rod for a forearm would need a hundred thousand.
    const Actor thin = makeActor(tubes({{"spine", 0.15f}, {"LeftArm", 0.06f}, {"LeftForeArm", 0.006f}, {"h", 0.1f}}),
                                 {});
    EXPECT_NEAR(static_cast<double>(thin.particles.size()), 4000.0, 80.0);
    EXPECT_TRUE(std::any_of(thin.notes.begin(), thin.notes.end(), [](const std::string& note) {
        return note.starts_with("Less than two particles thick: LeftForeArm; --diameter 0.006");
    }));
}

Actor ofCount(uint32_t wanted)
{
    ActorOptions options;
    options.particleCount = wanted;
    return makeActor(makeHumanoid(), options);
}

TEST(MakeActor, wantedCountsAreMet)
{
    for (const uint32_t wanted : {300u, 1000u, 5000u}) {
        EXPECT_NEAR(static_cast<double>(ofCount(wanted).particles.size()), wanted, 0.02 * wanted);
    }
    EXPECT_GE(ofCount(8).particles.size(), 1u) << "as near as there is";
    EXPECT_THROW(ofCount(2000000), std::logic_error);
}

}  // namespace
}  // namespace knuckle
