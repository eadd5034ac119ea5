#include <numbers>

#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/clip_ranges.h"
#include "sim/rig/joints/turn_parts.h"
#include "tests/rig/actor_fixture.h"
#include "tests/rig/figures/box_figure.h"

namespace knuckle::test {
namespace {

/// Turns of a person's left limb in a clip of one second, at 60 keys a second, from half a second on.
struct Excursion {
    std::string bone;
    Vector3f about;
    float degrees = 0.0f;
    int keys = 0;
    float before = 0.0f;  ///< The half second before [degrees].
};

/// The elbow's axis is -y: a positive turn about y bends it back.
Excursion bentElbow(float degrees, int keys, float forward = 0.0f)
{
    return {"forearm.L", Vector3f::UnitY(), degrees, keys, -forward};
}

/// Behind the back, some 48 degrees beyond the shoulder's cone.
Excursion armBehindBack(int keys)
{
    return {"upper_arm.L", Vector3f::UnitY(), 120, keys};
}

/// 40 degrees more than a shoulder turns.
Excursion twistedArm(int keys)
{
    return {"upper_arm.L", Vector3f::UnitX(), 130, keys};
}

Model personWith(const Excursion& excursion)
{
    Model model = boxFigure(boxPerson());
    Clip clip;
    clip.name = "wild";
    clip.duration = 1.0;
    const uint32_t first = indexOf(model, excursion.bone);
    for (int k = 0; k <= 60; ++k) {
        std::vector<Eigen::Matrix4f> poses;
        for (const Bone& bone : model.bones) poses.push_back(bone.restPose);
        const float degrees = k < 30 ? excursion.before : k < 30 + excursion.keys ? excursion.degrees : 0.0f;
        const Eigen::Matrix3f turn = Eigen::AngleAxisf(degrees * DEGREE, excursion.about).toRotationMatrix();
        poses[first].topLeftCorner<3, 3>() = turn;
        for (uint32_t b = 0; b < model.bones.size(); ++b)
            if (model.bones[b].parent == static_cast<int>(first)) poses[b].topLeftCorner<3, 3>() = turn;
        clip.keyTimes.push_back(k / 60.0);
        clip.poses.push_back(poses);
    }
    model.clips.push_back(clip);
    return model;
}

Actor actorWith(const Excursion& excursion)
{
    return make(personWith(excursion), 0.04f);
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

/// Whether a ball's limits include a turn.
bool holds(const ActorJoint& joint, const Quaternionf& turn)
{
    TurnReader reader(joint.limits, joint.type, joint.axis);
    const TurnParts parts = reader.read(turn);
    return parts.swing < joint.limits.swing && parts.twist > joint.limits.twist.lowest &&
           parts.twist < joint.limits.twist.highest;
}

Quaternionf turnOf(const Excursion& excursion)
{
    return Quaternionf(Eigen::AngleAxisf(excursion.degrees * DEGREE, excursion.about));
}

TEST(WildKeys, WhatLastsIsTakenInOnBothSides)
{
    const Actor actor = actorWith(bentElbow(40, 20));
    EXPECT_NEAR(backOf(actor, "forearm.L"), 45, 0.5f);
    EXPECT_NEAR(backOf(actor, "forearm.R"), 45, 0.5f);
    EXPECT_FALSE(hasNote(actor));
}

TEST(WildKeys, AMomentIsNotUnlessItIsNear)
{
    const Actor wild = actorWith(bentElbow(40, 3)), near = actorWith(bentElbow(20, 1));
    EXPECT_NEAR(backOf(wild, "forearm.L"), 5, 0.5f);
    EXPECT_NEAR(backOf(wild, "forearm.R"), 5, 0.5f);
    EXPECT_TRUE(hasNote(wild));
    EXPECT_NEAR(backOf(near, "forearm.L"), 25, 0.5f);
    EXPECT_FALSE(hasNote(near));
}

TEST(WildKeys, WhatIsFarBeyondABodysRangeIsToldNotTaken)
{
    const Actor actor = actorWith(bentElbow(86, 12, 80));
    EXPECT_NEAR(backOf(actor, "forearm.L"), 5, 0.5f);
    EXPECT_TRUE(hasNote(actor));
}

TEST(WildKeys, ShouldersTakeInWhatLastsAndNoMoment)
{
    for (const auto& excursion : {armBehindBack, twistedArm}) {
        const Excursion lasting = excursion(18), wild = excursion(3);
        const Actor taken = actorWith(lasting), left = actorWith(wild);
        EXPECT_TRUE(holds(jointOf(taken, "upper_arm.L"), turnOf(lasting)));
        EXPECT_FALSE(hasNote(taken));
        EXPECT_FALSE(holds(jointOf(left, "upper_arm.L"), turnOf(wild)));
        EXPECT_NEAR(jointOf(left, "upper_arm.L").limits.swing, 105 * DEGREE, 0.02f);
        EXPECT_NEAR(jointOf(left, "upper_arm.R").limits.swing, 105 * DEGREE, 0.02f);
        EXPECT_TRUE(hasNote(left));
    }
}

/// A tail's range is a guess: no turn that lasts is too far for it.
TEST(WildKeys, NothingThatLastsIsTooFarForATail)
{
    Model model = boxFigure(boxDog());
    Clip clip{.name = "sits", .duration = 1.0, .keyTimes = {}, .poses = {}};
    for (int k = 0; k <= 60; ++k) {
        std::vector<Eigen::Matrix4f> poses;
        for (const Bone& bone : model.bones) poses.push_back(bone.restPose);
        poses[indexOf(model, "Tail")].topLeftCorner<3, 3>() = turnOf({"", Vector3f::UnitX(), 110}).toRotationMatrix();
        clip.keyTimes.push_back(k / 60.0);
        clip.poses.push_back(poses);
    }
    model.clips.push_back(clip);
    const Actor actor = make(model, 0.04f);
    EXPECT_FALSE(hasNote(actor));
    EXPECT_TRUE(holds(jointOf(actor, "Tail"), turnOf({"", Vector3f::UnitX(), 110})));
}

TEST(WildKeys, AClipThatIsPlayedIsHeldWhereLimitsEnd)
{
    for (const Excursion& excursion : {bentElbow(86, 12, 80), armBehindBack(3), twistedArm(3)}) {
        const Model model = personWith(excursion);
        // Played by an actor that was made without the clip, and by one that was made with it.
        for (const bool own : {true, false}) {
            Model bare = model;
            bare.clips.clear();
            Actor actor = make(own ? model : bare, 0.04f);
            const JointLimits before = jointOf(actor, excursion.bone).limits;
            ActorClip made = own ? ownClip(actor, model, model.clips[0])
                                 : foreignClip(actor, readFigure(model), model.clips[0]);
            const std::string note = holdWithinLimits(actor, made.clip);
            EXPECT_TRUE(note.starts_with("Clip 'wild' turns joints beyond what a body's do, for a moment or by far, "
                                         "and is held at their limits: " +
                                         excursion.bone + " by "))
                << note;
            allow(actor, needsOf(actor, made.clip));
            const JointLimits& after = jointOf(actor, excursion.bone).limits;
            EXPECT_NEAR(after.swing, before.swing, 1e-4f);
            EXPECT_NEAR(after.twist.highest, before.twist.highest, 1e-4f);
            EXPECT_NEAR(after.bend.lowest, before.bend.lowest, 1e-4f);
        }
    }
}

TEST(WildKeys, AClipThatFitsStaysAsItIs)
{
    for (const Excursion& excursion : {bentElbow(40, 18), armBehindBack(18), twistedArm(18)}) {
        const Model model = personWith(excursion);
        Model bare = model;
        bare.clips.clear();
        Actor actor = make(bare, 0.04f);
        BodyClip clip = ownClip(actor, model, model.clips[0]).clip;
        const BodyClip before = clip;
        EXPECT_EQ(holdWithinLimits(actor, clip), "");
        for (size_t k = 0; k < clip.turns.size(); ++k) EXPECT_EQ(clip.turns[k].coeffs(), before.turns[k].coeffs());
        allow(actor, needsOf(actor, clip));
        if (excursion.bone == "upper_arm.L") EXPECT_TRUE(holds(jointOf(actor, excursion.bone), turnOf(excursion)));
        else EXPECT_NEAR(backOf(actor, "forearm.L"), 45, 0.5f);
    }
}

}  // namespace
}  // namespace knuckle::test
