#include "tools/humanoid/humanoid.h"
#include "sim/rig/import/import.h"
#include "tests/places.h"
#include "tests/tools/model_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace knuckle {
namespace {

using Eigen::Vector3f;

std::vector<Vector3f> pose(const Model& model, const std::vector<Eigen::Matrix4f>& bones)
{
    std::vector<Vector3f> posed;
    for (size_t v = 0; v < model.vertices.size(); ++v) {
        Eigen::Vector4f p = Eigen::Vector4f::Zero();
        for (size_t i = 0; i < 8; ++i) {
            const uint32_t bone = model.skin[v].bones[i];
            p += model.skin[v].weights[i] *
                 (bones[bone] * (model.bones[bone].restPose.inverse() * model.vertices[v].homogeneous()));
        }
        posed.push_back(p.head<3>());
    }
    return posed;
}

TEST(Humanoid, isAnAdultOf175CentimetresOnTheGround)
{
    const Model model = makeHumanoid();
    EXPECT_GE(model.bones.size(), 16u);
    EXPECT_LE(model.bones.size(), 20u);
    float low = 1e9f, high = -1e9f;
    for (const Vector3f& v : model.vertices) {
        low = std::min(low, v.y());
        high = std::max(high, v.y());
    }
    EXPECT_NEAR(low, 0.0f, 0.002f);
    EXPECT_NEAR(high, 1.75f, 0.005f);
}

TEST(Humanoid, meshIsClosed)
{
    EXPECT_EQ(test::openEdges(makeHumanoid()), 0);
}

TEST(Humanoid, coloursHaveSharpBorders)
{
    const Model model = makeHumanoid();
    for (const auto& triangle : model.triangles) {
        for (size_t i = 0; i < 3; ++i) {
            const Vector3f& a = model.surface.vertices[triangle[i]].color;
            const Vector3f& b = model.surface.vertices[triangle[(i + 1) % 3]].color;
            EXPECT_LT((a - b).norm(), 0.1f);  // the blush of a cheek
        }
    }
}

TEST(Humanoid, weightsSumToOne)
{
    for (const SkinWeights& skin : makeHumanoid().skin) {
        float sum = 0.0f;
        for (float weight : skin.weights) {
            sum += weight;
        }
        EXPECT_NEAR(sum, 1.0f, 2.1e-4f);  // four weights rounded to 1e-4
    }
}

TEST(Humanoid, danceLoopsAndMovesEveryLimb)
{
    const Model model = makeHumanoid();
    ASSERT_EQ(model.clips.size(), 2u);
    EXPECT_EQ(model.clips[1].name, "walk");
    const Clip& clip = model.clips[0];
    EXPECT_EQ(clip.poses.front(), clip.poses.back());
    EXPECT_EQ(clip.keyTimes.back(), clip.duration);
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        float travel = 0.0f;
        for (const auto& key : clip.poses) {
            travel = std::max(travel, (key[b] - clip.poses[0][b]).block<3, 1>(0, 3).norm());
        }
        EXPECT_GT(travel, 0.02f) << model.bones[b].name;
    }
}

TEST(Humanoid, walkGoesOnWhereItHasComeToAndItsFeetStand)
{
    const Model model = makeHumanoid();
    const Clip& clip = model.clips.at(1);
    const float stride = clip.poses.back()[HIPS](2, 3) - clip.poses.front()[HIPS](2, 3);
    EXPECT_NEAR(stride, 1.1f, 1e-5f);
    for (uint32_t b = 0; b < HUMANOID_BONE_COUNT; ++b) {
        Eigen::Matrix4f next = clip.poses.front()[b];
        next(2, 3) += stride;
        EXPECT_LT((clip.poses.back()[b] - next).norm(), 1e-5f) << b;
    }
    // The toes of at least one foot stay in place.
    const Eigen::Vector4f toe(0, -clip.poses[0][FOOT_L](1, 3), 0.19f, 1);
    for (size_t k = 1; k < clip.poses.size(); ++k) {
        float least = 1.0f;
        for (const uint32_t foot : {FOOT_L, FOOT_R})
            least = std::min(least, (clip.poses[k][foot] * toe - clip.poses[k - 1][foot] * toe).norm());
        EXPECT_LT(least, 2e-3f) << "key " << k;
    }
}

TEST(Humanoid, clipsKeepBoneLengthsAndFeetAboveTheFloor)
{
    const Model model = makeHumanoid();
    std::vector<std::vector<Eigen::Matrix4f>> keys;
    for (const Clip& clip : model.clips) keys.insert(keys.end(), clip.poses.begin(), clip.poses.end());
    for (const auto& key : keys) {
        for (uint32_t b = 1; b < model.bones.size(); ++b) {
            const auto length = [&](const Eigen::Matrix4f& x, const Eigen::Matrix4f& y) {
                return (x - y).block<3, 1>(0, 3).norm();
            };
            const int32_t parent = model.bones[b].parent;
            EXPECT_NEAR(length(key[b], key[parent]), length(model.bones[b].restPose, model.bones[parent].restPose),
                        1e-5f)
                << model.bones[b].name;
        }
        for (const Vector3f& v : pose(model, key)) {
            EXPECT_GT(v.y(), -0.004f);  // 4 mm: blended skin between shin and foot may reach below the ground
        }
    }
}

TEST(Humanoid, committedFileIsWhatTheCodeMakes)
{
    test::expectCommitted("humanoid", makeHumanoid());
}

TEST(Humanoid, fileComesBackAsItWas)
{
    const Model made = makeHumanoid(), read = importModel(test::inSource("assets/models/humanoid.glb"));
    // By place: assimp's versions differ in the order of vertices. Places are multiples of a tenth of a millimetre.
    const auto places = [](const Model& model) {
        std::multiset<std::array<long, 3>> all;
        for (const Vector3f& v : model.vertices)
            all.insert({std::lround(1e4f * v.x()), std::lround(1e4f * v.y()), std::lround(1e4f * v.z())});
        return all;
    };
    EXPECT_TRUE(places(read) == places(made));
    ASSERT_EQ(read.bones.size(), made.bones.size());
    std::map<std::string, Eigen::Matrix4f> rest;
    for (const Bone& bone : made.bones) {
        rest[bone.name] = bone.restPose;
    }
    for (const Bone& bone : read.bones) {
        EXPECT_LT((bone.restPose - rest.at(bone.name)).norm(), 1e-5f) << bone.name;
    }
    ASSERT_EQ(read.clips.size(), 2u);
    for (size_t c = 0; c < 2; ++c) {
        EXPECT_EQ(read.clips[c].name, made.clips[c].name);
        EXPECT_NEAR(read.clips[c].duration, made.clips[c].duration, 1e-3);
    }
}

}  // namespace
}  // namespace knuckle
