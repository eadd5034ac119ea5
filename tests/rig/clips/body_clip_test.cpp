#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/bone_match.h"
#include "tests/message_of.h"
#include "tools/dog/dog.h"
#include "tools/humanoid/humanoid.h"
#include "tools/spider/spider.h"

namespace knuckle::test {

namespace {

const Model& figure()
{
    static const Model model = makeHumanoid();
    return model;
}

const Actor& actor()
{
    static const Actor made = [] {
        ActorOptions options;
        options.voxels.diameter = 0.05f;
        return makeActor(figure(), options);
    }();
    return made;
}

/// Its bones under other names, larger, and facing elsewhere.
Model disguised(const std::map<std::string, std::string>& names, float scale, float yaw)
{
    Model model = figure();
    Eigen::Matrix4f turned = Eigen::Matrix4f::Identity();
    turned.topLeftCorner<3, 3>() = Eigen::AngleAxisf(yaw, Vector3f::UnitY()).toRotationMatrix();
    const auto change = [&](Eigen::Matrix4f& pose) {
        pose.block<3, 1>(0, 3) *= scale;
        pose = turned * pose;
    };
    for (Bone& bone : model.bones) {
        bone.name = names.at(bone.name);
        change(bone.restPose);
    }
    for (Clip& clip : model.clips)
        for (auto& poses : clip.poses)
            for (Eigen::Matrix4f& pose : poses) change(pose);
    return model;
}

const std::map<std::string, std::string> MIXAMO = {
    {"hips", "mixamorig:Hips"},
    {"spine", "mixamorig:Spine"},
    {"chest", "mixamorig:Spine1"},
    {"neck", "mixamorig:Neck"},
    {"head", "mixamorig:Head"},
    {"clavicle.L", "mixamorig:LeftShoulder"},
    {"upper_arm.L", "mixamorig:LeftArm"},
    {"forearm.L", "mixamorig:LeftForeArm"},
    {"hand.L", "mixamorig:LeftHand"},
    {"clavicle.R", "mixamorig:RightShoulder"},
    {"upper_arm.R", "mixamorig:RightArm"},
    {"forearm.R", "mixamorig:RightForeArm"},
    {"hand.R", "mixamorig:RightHand"},
    {"thigh.L", "mixamorig:LeftUpLeg"},
    {"shin.L", "mixamorig:LeftLeg"},
    {"foot.L", "mixamorig:LeftFoot"},
    {"thigh.R", "mixamorig:RightUpLeg"},
    {"shin.R", "mixamorig:RightLeg"},
    {"foot.R", "mixamorig:RightFoot"},
};

}  // namespace

TEST(BodyClip, BodiesTurnAsTheirBonesWhereJointsLetThem)
{
    const Clip& dance = figure().clips.front();
    const BodyClip clip = ownClip(actor(), figure(), dance).clip;
    ASSERT_EQ(clip.keyCount(), dance.poses.size());
    EXPECT_NEAR(clip.duration(), dance.duration, 1e-4);
    for (uint32_t k = 0; k < clip.keyCount(); ++k) {
        std::vector<Quaternionf> whole(actor().bodies.size());
        for (uint32_t b = 0; b < actor().bodies.size(); ++b) {
            const ActorBody& body = actor().bodies[b];
            const Quaternionf& turn = clip.turns[k * clip.bodyCount + b];
            whole[b] = body.parent < 0 ? turn : whole[body.parent] * turn;
            // Balls and the first body are at their bones' places; beyond a hinge only the hinge itself.
            const auto bone = std::ranges::find(figure().bones, body.name, &Bone::name) - figure().bones.begin();
            const Eigen::Matrix3f wanted = dance.poses[k][bone].topLeftCorner<3, 3>() *
                                           figure().bones[bone].restPose.topLeftCorner<3, 3>().transpose();
            const bool hinge = body.name.starts_with("shin") || body.name.starts_with("forearm");
            if (!hinge) {
                EXPECT_LT(whole[b].angularDistance(Quaternionf(wanted)), 2e-3f) << body.name << " key " << k;
            }
            if (hinge) {
                const auto joint = std::ranges::find(actor().joints, b, &ActorJoint::child);
                EXPECT_LT(turn.vec().cross(joint->axis).norm(), 1e-5f) << body.name << " key " << k;
            }
        }
    }
}

TEST(BodyClip, TheSameDanceComesFromASkeletonOfOtherNamesSizeAndDirection)
{
    const BodyClip own = ownClip(actor(), figure(), figure().clips.front()).clip;
    const Model other = disguised(MIXAMO, 2.5f, 1.2f);
    const ActorClip foreign = foreignClip(actor(), readFigure(other), other.clips.front());
    ASSERT_EQ(foreign.clip.turns.size(), own.turns.size());
    for (size_t i = 0; i < own.turns.size(); ++i) {
        const uint32_t body = static_cast<uint32_t>(i % own.bodyCount);
        EXPECT_LT(foreign.clip.turns[i].angularDistance(own.turns[i]), 5e-3f)
            << actor().bodies[body].name << " key " << i / own.bodyCount;
    }
    // The path begins at the figure's place, and has the same length.
    for (size_t k = 0; k < own.roots.size(); ++k) {
        const Vector3f moved = own.roots[k] - own.roots[0];
        EXPECT_LT((foreign.clip.roots[k] - foreign.clip.roots[0] - moved).norm(), 0.01f * moved.norm() + 1e-3f) << k;
    }
    EXPECT_NEAR(foreign.clip.roots[0].x(), pivotOf(actor()).x(), 1e-4f);
    EXPECT_NEAR(foreign.clip.roots[0].z(), pivotOf(actor()).z(), 1e-4f);
}

/// Its feet may not be its lowest bones, and its body may be no higher than they are, as a spider's.
TEST(BodyClip, AClipOfTheSameSkeletonIsPlayedAsItIs)
{
    for (const Model& model : {makeDog(), makeSpider()}) {
        ActorOptions options;
        options.voxels.diameter = 0.05f;
        const Actor made = makeActor(model, options);
        for (const Clip& clip : model.clips) {
            const BodyClip own = ownClip(made, model, clip).clip,
                           foreign = foreignClip(made, readFigure(model), clip).clip;
            ASSERT_EQ(foreign.roots.size(), own.roots.size());
            for (size_t i = 0; i < own.turns.size(); ++i)
                EXPECT_LT(foreign.turns[i].angularDistance(own.turns[i]), 2e-3f) << model.name << " " << i;
            for (size_t k = 0; k < own.roots.size(); ++k) {
                const Vector3f off = (foreign.roots[k] - foreign.roots[0]) - (own.roots[k] - own.roots[0]);
                EXPECT_LT(off.norm(), 1e-3f) << model.name << " key " << k;
                EXPECT_NEAR(foreign.roots[k].y(), own.roots[k].y(), 1e-3f) << model.name << " key " << k;
            }
        }
    }
}

TEST(BodyClip, WhatNoBoneMovesGoesWithItsParentAndIsTold)
{
    std::map<std::string, std::string> names = MIXAMO;
    names["hand.L"] = "item";
    const Model other = disguised(names, 1.0f, 0.0f);
    const ActorClip made = foreignClip(actor(), readFigure(other), other.clips.front());
    const auto hand = std::ranges::find(actor().bodies, "hand.L", &ActorBody::name) - actor().bodies.begin();
    for (uint32_t k = 0; k < made.clip.keyCount(); ++k)
        EXPECT_LT(made.clip.turns[k * made.clip.bodyCount + hand].angularDistance(Quaternionf::Identity()), 1e-6f);
    ASSERT_FALSE(made.notes.empty());
    EXPECT_EQ(made.notes.back(), "Clip 'dance' does not move hand.L: no bone of its file is that.");
}

TEST(BodyClip, ASkeletonWithoutNamesIsMatchedByItsShape)
{
    std::map<std::string, std::string> names;
    for (const auto& [ours, theirs] : MIXAMO) names[ours] = fmt::format("thing{}", names.size());
    const Model other = disguised(names, 1.5f, 1.0f);
    const ActorClip made = foreignClip(actor(), readFigure(other), other.clips.front());
    const ActorClip own = ownClip(actor(), figure(), figure().clips.front());
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    for (size_t i = 0; i < own.clip.turns.size(); ++i)
        ASSERT_LT(made.clip.turns[i].angularDistance(own.clip.turns[i]), 0.02f) << i;
}

TEST(BodyClip, AnActorWithoutNamesIsMatchedByItsShape)
{
    std::map<std::string, std::string> names, ours;
    for (const auto& [own, theirs] : MIXAMO) {
        names[own] = fmt::format("thing{}", names.size());
        ours[names[own]] = theirs;
    }
    ActorOptions options;
    options.voxels.diameter = 0.05f;
    const Actor nameless = makeActor(disguised(names, 1.0f, 0.0f), options);
    const Model source = disguised(MIXAMO, 1.0f, 0.0f);
    const std::vector<uint32_t> match = matchBones(anatomyOf(nameless), readFigure(source));
    for (uint32_t b = 0; b < match.size(); ++b) {
        ASSERT_NE(match[b], NO_INDEX) << nameless.bodies[b].name;
        EXPECT_EQ(source.bones[match[b]].name, ours[nameless.bodies[b].name]);
    }
}

TEST(BodyClip, ASkeletonOfNothingKnownIsRefusedWithNamesOfBoth)
{
    Model other;
    other.bones = {{"thing0"}, {"thing1", 0}};
    other.clips = {{"idle", 1.0, {0.0}, {{Eigen::Matrix4f::Identity(), Eigen::Matrix4f::Identity()}}}};
    const std::string message = messageOf<InputError>(
        [&] { foreignClip(actor(), readFigure(other), other.clips.front()); });
    EXPECT_TRUE(message.starts_with("none of its bones (thing")) << message;
    EXPECT_NE(message.find("is one of the actor's (spine"), std::string::npos) << message;
}

}  // namespace knuckle::test
