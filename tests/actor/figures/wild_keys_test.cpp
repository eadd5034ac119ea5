#include <numbers>

#include "tests/actor/actor_fixture.h"
#include "tests/actor/figures/box_figure.h"

namespace knuckle::test {
namespace {

constexpr float DEGREE = std::numbers::pi_v<float> / 180;

/// A person in whose clip of one second, at 60 keys a second, the left elbow is bent back by an angle for some keys.
/// @param forward how far it is bent the right way for half a second before [degrees].
Actor withBentElbow(float degrees, int keys, float forward = 0.0f)
{
    Model model = boxFigure(boxPerson());
    Clip clip;
    clip.name = "wild";
    clip.duration = 1.0;
    const uint32_t forearm = indexOf(model, "forearm.L");
    for (int k = 0; k <= 60; ++k) {
        std::vector<Eigen::Matrix4f> poses;
        for (const Bone& bone : model.bones) poses.push_back(bone.restPose);
        // The elbow's axis is -y: a positive turn about y bends it back.
        const float angle = (k < 30 ? -forward : k < 30 + keys ? degrees : 0.0f) * DEGREE;
        poses[forearm].topLeftCorner<3, 3>() = Eigen::AngleAxisf(angle, Vector3f::UnitY()).toRotationMatrix();
        clip.keyTimes.push_back(k / 60.0);
        clip.poses.push_back(poses);
    }
    model.clips.push_back(clip);
    return make(model, 0.04f);
}

float backOf(const Actor& actor, const std::string& elbow)
{
    return -jointOf(actor, elbow).limits.bend.lowest / DEGREE;
}

bool hasNote(const Actor& actor)
{
    return std::ranges::any_of(actor.notes, [](const std::string& note) {
        return note.find("Clips turn joints beyond what a body's do") != note.npos;
    });
}

TEST(WildKeys, WhatLastsIsTakenInOnBothSides)
{
    const Actor actor = withBentElbow(40, 20);
    EXPECT_NEAR(backOf(actor, "forearm.L"), 45, 0.5f);
    EXPECT_NEAR(backOf(actor, "forearm.R"), 45, 0.5f);
    EXPECT_FALSE(hasNote(actor));
}

TEST(WildKeys, AMomentIsNotUnlessItIsNear)
{
    const Actor wild = withBentElbow(40, 3), near = withBentElbow(20, 1);
    EXPECT_NEAR(backOf(wild, "forearm.L"), 5, 0.5f);
    EXPECT_NEAR(backOf(wild, "forearm.R"), 5, 0.5f);
    EXPECT_TRUE(hasNote(wild));
    EXPECT_NEAR(backOf(near, "forearm.L"), 25, 0.5f);
    EXPECT_FALSE(hasNote(near));
}

TEST(WildKeys, WhatIsFarBeyondABodysRangeIsToldNotTaken)
{
    const Actor actor = withBentElbow(86, 12, 80);
    EXPECT_NEAR(backOf(actor, "forearm.L"), 5, 0.5f);
    EXPECT_TRUE(hasNote(actor));
}

}  // namespace
}  // namespace knuckle::test
