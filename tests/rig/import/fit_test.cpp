#include "sim/rig/import/fit.h"

#include <gtest/gtest.h>

#include "sim/base/errors.h"
#include "tests/message_of.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

/// Two points and two bones between them, with a clip of one key.
Model stick(const Vector3f& low, const Vector3f& high)
{
    Model model;
    model.vertices = {low, high};
    model.triangles = {{0, 1, 0}};
    for (int b = 0; b < 2; ++b) {
        Bone bone{b == 0 ? "hips" : "head", b - 1};
        bone.restPose.block<3, 1>(0, 3) = b == 0 ? low : high;
        model.bones.push_back(bone);
    }
    model.clips = {{"still", 1.0, {0.0}, {{model.bones[0].restPose, model.bones[1].restPose}}}};
    return model;
}

/// Checks that mesh, skeleton and clips have moved together.
void expectAt(const Model& model, const Vector3f& low, const Vector3f& high)
{
    const float close = 1e-5f * (1.0f + high.norm());
    for (int b = 0; b < 2; ++b) {
        const Vector3f wanted = b == 0 ? low : high;
        EXPECT_LT((model.vertices[b] - wanted).norm(), close) << b;
        EXPECT_LT((model.bones[b].restPose.block<3, 1>(0, 3) - wanted).norm(), close) << b;
        EXPECT_LT((model.clips[0].poses[0][b].block<3, 1>(0, 3) - wanted).norm(), close) << b;
    }
}

TEST(Fit, aHeightDecidesTheScale)
{
    Model model = stick({0, 1, 0}, {1, 5, 0});
    fitModel(model, {.height = 2.0});
    expectAt(model, {0, 0.5f, 0}, {0.5f, 2.5f, 0});
    EXPECT_TRUE(model.notes.empty());
    Model flat = stick({0, 1, 0}, {1, 1, 0});
    EXPECT_THROW(fitModel(flat, {.height = 2.0}), InputError);
}

TEST(Fit, whatStandsAlongZIsTurnedUp)
{
    Model model = stick({0, 0, 0}, {0.25f, 0.5f, 1.5f});
    fitModel(model, {.up = UpAxis::Z});
    expectAt(model, {0, 0, 0}, {0.25f, 1.5f, -0.5f});
}

TEST(Fit, centersAllOrWhatIsFar)
{
    Model near = stick({3, 2, 5}, {4, 4, 5});
    fitModel(near, {.centering = Centering::WhereFar});
    expectAt(near, {3, 2, 5}, {4, 4, 5});
    fitModel(near, {.centering = Centering::Always});
    expectAt(near, {-0.5f, 0, 0}, {0.5f, 2, 0});
    EXPECT_TRUE(near.notes.empty());

    Model far = stick({3000, 2, 5}, {3001, 4, 5});
    fitModel(far, {});
    EXPECT_TRUE(far.notes.empty()) << "its origin may be meant";
    fitModel(far, {.centering = Centering::WhereFar});
    EXPECT_LT(far.vertices[1].norm(), 3.0f);
    ASSERT_EQ(far.notes.size(), 1u);
    EXPECT_EQ(far.notes[0], "The model stood 3e+03 m from its origin and was moved there.");
}

TEST(Fit, oddSizesAreAskedAboutUnlessGiven)
{
    Model giant = stick({0, 0, 0}, {0, 11, 0}), dwarf = stick({0, 0, 0}, {0, 0.3f, 0});
    fitModel(giant, {});
    fitModel(dwarf, {});
    ASSERT_EQ(giant.notes.size(), 1u);
    EXPECT_NE(giant.notes[0].find("The figure is 11 m high"), std::string::npos);
    ASSERT_EQ(dwarf.notes.size(), 1u);
    EXPECT_NE(dwarf.notes[0].find("--height 1.8"), std::string::npos);
    Model wide = stick({0, 0, 0}, {6, 1.76f, 0});
    fitModel(wide, {});
    ASSERT_EQ(wide.notes.size(), 1u);
    EXPECT_TRUE(wide.notes[0].starts_with("The figure is 6 m across, larger than people")) << wide.notes[0];
    Model told = stick({0, 0, 0}, {0, 11, 0}), tree = stick({0, 0, 0}, {0, 11, 0});
    fitModel(told, {.scale = 1.0});
    EXPECT_TRUE(told.notes.empty());
    tree.bones.clear();
    tree.clips.clear();
    fitModel(tree, {});
    EXPECT_TRUE(tree.notes.empty()) << "what has no skeleton may have any size";
}

TEST(Fit, aSizeThatCannotBeIsRefusedWithTheOptions)
{
    Model speck = stick({0, 0, 0}, {0, 0.003f, 0});
    const std::string message = test::messageOf<InputError>([&] { fitModel(speck, {}); });
    EXPECT_NE(message.find("give --height, or --scale (in scenes `scale`)"), std::string::npos) << message;
}

}  // namespace
}  // namespace knuckle
