#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/tools/model_checks.h"
#include "tools/dog/dog.h"
#include "tools/spider/spider.h"

namespace knuckle {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

/// The point of a foot that does not move while it is no higher than at rest.
struct Foot {
    std::string bone;
    Vector3f tip;  // [m]
};

struct Creature {
    const char* name;
    Model (*make)();
    std::vector<Foot> feet;
};

Creature dog()
{
    return {"dog",
            makeDog,
            {{"front_foot.L", {0.085f, 0, 0.236f}},
             {"front_foot.R", {-0.085f, 0, 0.236f}},
             {"back_toe.L", {0.088f, 0, -0.236f}},
             {"back_toe.R", {-0.088f, 0, -0.236f}}}};
}

Creature spider()
{
    std::vector<Foot> feet;
    for (const Bone& bone : makeSpider().bones)
        if (bone.name.find("tibia") != std::string::npos) feet.push_back({bone.name, spiderFoot(bone.name)});
    return {"spider", makeSpider, feet};
}

class Creatures : public testing::TestWithParam<Creature> {};

size_t indexOf(const Model& model, const std::string& bone)
{
    return static_cast<size_t>(std::ranges::find(model.bones, bone, &Bone::name) - model.bones.begin());
}

TEST_P(Creatures, standOnTheGroundInAClosedSkin)
{
    const Model model = GetParam().make();
    EXPECT_EQ(test::openEdges(model), 0u);
    const auto low = std::ranges::min_element(model.vertices, {}, [](const Vector3f& v) { return v.y(); });
    EXPECT_NEAR(low->y(), 0.0f, 0.002f);
    for (const SkinWeights& skin : model.skin) {
        float sum = 0.0f;
        for (const float weight : skin.weights) sum += weight;
        EXPECT_NEAR(sum, 1.0f, 2.1e-4f);  // four weights rounded to 1e-4
    }
}

TEST_P(Creatures, goOnWhereTheyHaveComeTo)
{
    for (const Clip& clip : GetParam().make().clips) {
        const Matrix4f way = clip.poses.back()[0] * clip.poses.front()[0].inverse();
        EXPECT_GT(way(2, 3), 0.3f);
        for (size_t b = 0; b < clip.poses[0].size(); ++b)
            EXPECT_LT((clip.poses.back()[b] - way * clip.poses.front()[b]).norm(), 1e-4f) << clip.name << " " << b;
    }
}

TEST_P(Creatures, keepTheirBonesTogether)
{
    const Model model = GetParam().make();
    for (const Clip& clip : model.clips) {
        for (const auto& pose : clip.poses) {
            for (size_t b = 1; b < model.bones.size(); ++b) {
                const auto parent = static_cast<size_t>(model.bones[b].parent);
                const Eigen::Vector4f head = pose[parent] * model.bones[parent].restPose.inverse() *
                                             model.bones[b].restPose.col(3);
                EXPECT_LT((pose[b].col(3) - head).norm(), 1e-4f) << clip.name << " " << model.bones[b].name;
            }
        }
    }
}

/// Points on the ground do not move, and each foot is there for at least a third of the time.
TEST_P(Creatures, doNotSlide)
{
    const Model model = GetParam().make();
    for (const Clip& clip : model.clips) {
        for (const Foot& foot : GetParam().feet) {
            const size_t bone = indexOf(model, foot.bone);
            ASSERT_LT(bone, model.bones.size());
            const Eigen::Vector4f tip = model.bones[bone].restPose.inverse() * foot.tip.homogeneous();
            size_t standing = 0;
            for (size_t k = 1; k < clip.poses.size(); ++k) {
                const Eigen::Vector4f before = clip.poses[k - 1][bone] * tip, now = clip.poses[k][bone] * tip;
                EXPECT_GT(now.y(), foot.tip.y() - 1e-3f) << clip.name << " " << foot.bone << " key " << k;
                if (std::max(before.y(), now.y()) > foot.tip.y() + 1e-3f) continue;
                EXPECT_LT((now - before).norm(), 1.5e-3f) << clip.name << " " << foot.bone << " key " << k;
                ++standing;
            }
            EXPECT_GE(3 * standing, clip.poses.size() - 1) << clip.name << " " << foot.bone;
        }
    }
}

TEST_P(Creatures, areCommittedAsTheCodeMakesThem)
{
    test::expectCommitted(GetParam().name, GetParam().make());
}

INSTANTIATE_TEST_SUITE_P(All, Creatures, testing::Values(dog(), spider()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace knuckle
