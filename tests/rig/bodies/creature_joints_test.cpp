#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/rig/clips/body_clip.h"
#include "tests/rig/actor_fixture.h"
#include "tools/dog/dog.h"
#include "tools/humanoid/humanoid.h"
#include "tools/spider/spider.h"

namespace knuckle {

namespace {

const Model& dog()
{
    static const Model model = makeDog();
    return model;
}

const Model& spider()
{
    static const Model model = makeSpider();
    return model;
}

Model withoutNames(Model model)
{
    for (size_t b = 0; b < model.bones.size(); ++b) model.bones[b].name = "node" + std::to_string(b);
    return model;
}

Model withoutClips(Model model)
{
    model.clips.clear();
    return model;
}

const ActorJoint& jointOf(const Actor& actor, const Model& model, const std::string& bone)
{
    for (size_t b = 0; b < model.bones.size(); ++b) {
        if (model.bones[b].name != bone) continue;
        for (const ActorJoint& joint : actor.joints)
            if (joint.name == bone || joint.name == "node" + std::to_string(b)) return joint;
    }
    throw std::logic_error("no joint " + bone);
}

/// The direction in which a folding joint moves what hangs on it: limits are from the rest pose, positive in that
/// direction.
Vector3f foldOf(const Actor& actor, const ActorJoint& joint)
{
    EXPECT_EQ(joint.type, JointType::Hinge) << joint.name;
    EXPECT_GE(joint.limits.bend.highest, 30 * DEGREE) << joint.name;
    EXPECT_LT(joint.limits.bend.highest, 150 * DEGREE) << joint.name;
    EXPECT_GT(joint.limits.bend.lowest, -65 * DEGREE) << joint.name;
    Vector3f middle = Vector3f::Zero();
    const std::vector<uint32_t>& particles = actor.bodies[joint.child].particles;
    for (const uint32_t p : particles) middle += actor.particles[p] / float(particles.size());
    return joint.axis.cross(middle - joint.anchor).normalized();
}

void expectDogsLegs(const Actor& actor)
{
    for (const char side : {'L', 'R'}) {
        const auto joint = [&](const std::string& bone) -> const ActorJoint& {
            return jointOf(actor, dog(), bone + "." + side);
        };
        EXPECT_GT(foldOf(actor, joint("front_lower_leg")).z(), 0.7f);
        EXPECT_LT(foldOf(actor, joint("back_lower_leg")).z(), -0.3f);
        for (const char* root : {"front_shoulder", "front_upper_leg", "back_upper_leg"}) {
            EXPECT_EQ(joint(root).type, JointType::Ball) << root;
            EXPECT_LT(joint(root).limits.swing, 65 * DEGREE) << root;
            EXPECT_TRUE(joint(root).limits.twist.bounded()) << root;
        }
        EXPECT_LT(joint("front_shoulder").limits.swing, 30 * DEGREE);
    }
}

void expectSpidersLegs(const Actor& actor)
{
    for (const std::string leg : {"front_", "middle_", "rear_"}) {
        for (const char side : {'L', 'R'}) {
            const auto joint = [&](const std::string& bone) -> const ActorJoint& {
                return jointOf(actor, spider(), leg + bone + "." + side);
            };
            // Down and inwards.
            EXPECT_LT(foldOf(actor, joint("tibia")).x() * (side == 'L' ? 1.0f : -1.0f), 0.0f) << leg;
            for (const char* root : {"coxa", "femur"}) {
                EXPECT_EQ(joint(root).type, JointType::Ball) << root;
                EXPECT_LT(joint(root).limits.swing, 65 * DEGREE) << root;
            }
        }
    }
}

}  // namespace

TEST(CreatureJoints, ADogsElbowsFoldForwardAndItsKneesBack)
{
    expectDogsLegs(make(dog(), 0.03f));
    expectDogsLegs(make(withoutClips(dog()), 0.03f));
}

TEST(CreatureJoints, ADogIsADogWithoutNames)
{
    expectDogsLegs(make(withoutNames(dog()), 0.03f));
    expectDogsLegs(make(withoutNames(withoutClips(dog())), 0.03f));
}

TEST(CreatureJoints, ASpidersLegsHaveLimits)
{
    expectSpidersLegs(make(spider(), 0.03f));
    expectSpidersLegs(make(withoutNames(spider()), 0.03f));
}

TEST(CreatureJoints, BothSidesAreAlike)
{
    for (const Model* model : {&dog(), &spider()}) {
        const Actor actor = make(*model, 0.03f);
        for (const ActorJoint& left : actor.joints) {
            if (!left.name.ends_with(".L")) continue;
            const ActorJoint& right = jointOf(actor, *model, left.name.substr(0, left.name.size() - 1) + "R");
            EXPECT_NEAR(left.limits.swing, right.limits.swing, 0.5f * DEGREE) << left.name;
            EXPECT_NEAR(left.limits.bend.lowest, right.limits.bend.lowest, 0.5f * DEGREE) << left.name;
            EXPECT_NEAR(left.limits.bend.highest, right.limits.bend.highest, 0.5f * DEGREE) << left.name;
            EXPECT_NEAR(left.limits.twist.lowest, -right.limits.twist.highest, 0.5f * DEGREE) << left.name;
        }
    }
}

float angleAbout(const Vector3f& axis, const Quaternionf& turn)
{
    return std::remainder(2 * std::atan2(turn.vec().dot(axis), turn.w()), 2 * static_cast<float>(M_PI));
}

TEST(CreatureJoints, EveryPoseOfEveryClipIsWithinTheLimits)
{
    const Model figure = makeHumanoid();
    for (const Model* model : {&dog(), &spider(), &figure}) {
        const Actor actor = make(*model, 0.03f);
        for (const Clip& source : model->clips) {
            const BodyClip clip = ownClip(actor, *model, source).clip;
            for (const ActorJoint& joint : actor.joints) {
                const JointLimits& limits = joint.limits;
                ASSERT_TRUE(limits.any()) << joint.name;
                const bool hinge = joint.type == JointType::Hinge;
                const TurnRange& range = hinge ? limits.bend : limits.twist;
                const Vector3f middle = limits.cone.isZero() ? joint.axis : limits.cone.normalized();
                const Quaternionf lean = hinge ? Quaternionf::Identity()
                                               : Quaternionf::FromTwoVectors(joint.axis, middle);
                for (const Quaternionf& turn : turnsOf(clip, joint.child)) {
                    const float angle = angleAbout(joint.axis, lean.conjugate() * turn);
                    ASSERT_GT(angle, range.lowest) << joint.name << " in " << source.name;
                    ASSERT_LT(angle, range.highest) << joint.name << " in " << source.name;
                    if (hinge) continue;
                    ASSERT_GT(middle.dot(turn * joint.axis), std::cos(limits.swing)) << joint.name;
                }
            }
        }
    }
}

/// A clip turns one foot down by 80 degrees, and not the other one.
TEST(CreatureJoints, LimitsHoldWhatClipsDoOnBothSides)
{
    Model model = makeHumanoid();
    std::vector<Eigen::Matrix4f> poses;
    for (const Bone& bone : model.bones) poses.push_back(bone.restPose);
    const Eigen::Matrix3f back = Eigen::AngleAxisf(80 * DEGREE, Vector3f::UnitX()).toRotationMatrix();
    for (size_t b = 0; b < model.bones.size(); ++b)
        if (model.bones[b].name == "foot.L") poses[b].topLeftCorner<3, 3>() = back * poses[b].topLeftCorner<3, 3>();
    model.clips = {{"point", 1.0, {0.0}, {poses}}};
    const Actor actor = make(model, 0.04f);
    for (const char* name : {"foot.L", "foot.R"}) {
        const ActorJoint& foot = jointOf(actor, model, name);
        const Vector3f now = back * foot.axis;
        EXPECT_GT(now.dot(foot.limits.cone), std::cos(foot.limits.swing)) << name;
        EXPECT_LT(foot.limits.swing, 75 * DEGREE) << name;
    }
    ArticulationOptions options;
    options.limits["foot.L"].swing = 10 * DEGREE;
    const Actor wanted = make(model, 0.04f, options);
    EXPECT_EQ(jointOf(wanted, model, "foot.L").limits.swing, 10 * DEGREE);
}

TEST(CreatureJoints, WhatIsMergedOnOneSideStaysOnTheOther)
{
    for (const std::string side : {"L", "R"}) {
        ArticulationOptions options;
        options.merge = {"hand." + side};
        const Actor actor = make(makeHumanoid(), 0.035f, options);
        const auto has = [&](const std::string& name) {
            return std::ranges::any_of(actor.bodies, [&](const ActorBody& body) { return body.name == name; });
        };
        EXPECT_FALSE(has("hand." + side));
        EXPECT_TRUE(has(side == "L" ? "hand.R" : "hand.L"));
        EXPECT_TRUE(has("forearm." + side));
    }
}

TEST(CreatureJoints, AMachinesBoomIsAHinge)
{
    const Actor actor = make(twoBoneBox("boom"), 0.1f);
    const ActorJoint& boom = actor.joints.at(0);
    EXPECT_EQ(boom.type, JointType::Hinge);
    EXPECT_GT(std::abs(boom.axis.x()), 0.99f);
    EXPECT_NEAR(boom.limits.bend.lowest, -60 * DEGREE, 1e-4f);
    EXPECT_NEAR(boom.limits.bend.highest, 60 * DEGREE, 1e-4f);
}

}  // namespace knuckle
