#include <cmath>

#include "tests/app/one_object_scene.h"

namespace knuckle::test {

namespace {

/// An actor of the project's figure with additional fields.
std::string figure(const std::string& fields)
{
    return R"({"type": "actor", "file": "FILE")" + fields + "}";
}

const std::string DANCE = R"(, "animation": {"clip": "dance"})";

}  // namespace

TEST(SceneAnimation, SaysWhatClipsAreWhenAndHow)
{
    const World world = worldOf(figure(R"(, "position": [1, 2, 3], "animation": {"clip": "dance", "start": 0.5,
        "speed": 2, "loop": false, "root": "inPlace", "then": [{"at": 3, "clip": "dance", "fade": 0.5}, {"at": 4,
        "clip": "dance"}]}, "repeat": {"counts": [2, 1, 1], "spacing": [2, 2, 2]})"));
    ASSERT_EQ(world.clips.size(), 1u);
    EXPECT_EQ(world.clips[0].bodyCount, world.objects[0].bodyCount);
    EXPECT_NEAR(world.clips[0].duration(), 8.0f, 1e-4f);
    ASSERT_EQ(world.animations.size(), 2u);
    for (const Animation& animation : world.animations) {
        ASSERT_EQ(animation.plays.size(), 3u);
        const ClipPlay &first = animation.plays[0], &second = animation.plays[1];
        EXPECT_EQ(first.start, 0.5f);
        EXPECT_EQ(first.speed, 2.0f);
        EXPECT_FALSE(first.loop);
        EXPECT_TRUE(first.inPlace);
        EXPECT_EQ(second.at, 3.0f);
        EXPECT_EQ(second.fade, 0.5f);
        EXPECT_TRUE(second.loop);
        EXPECT_EQ(animation.plays[2].fade, 0.25f);
    }
    EXPECT_NEAR(world.animations[1].pose.translation.x() - world.animations[0].pose.translation.x(), 2.0f, 1e-5f);
    for (const Body& body : world.bodies) EXPECT_EQ(body.motion, Motion::Animated) << body.name;
}

/// Joints hold in the figure's clip: bodies that share particles agree about their places.
TEST(SceneAnimation, JointsAreShutThroughoutAClip)
{
    const World world = worldOf(figure(DANCE));
    for (float time = 0; time < 12; time += 0.0371f) {
        const std::vector<Pose> poses = bodyPlaces(world, world.animations[0], time);
        std::vector<Vector3f> places(world.particles.size(), Vector3f::Constant(NAN));
        for (const Link& link : world.links) {
            const Vector3f place = poses[link.body].apply(link.restOffset);
            Vector3f& known = places[link.particle];
            if (!known.allFinite()) known = place;
            // Rounding of places at 2 m, over a chain of seven bodies.
            EXPECT_LT((known - place).norm(), 3e-6f) << "at " << time << " s, particle " << link.particle;
        }
    }
}

/// Distance of a joint from the nearer end of its limits, by the turns of both bodies; negative beyond them.
float roomOf(const Joint& joint, const Quaternionf& parent, const Quaternionf& child)
{
    const Quaternionf a = parent * joint.parentSide.frame, b = child * joint.childSide.frame;
    const Quaternionf turn = a.conjugate() * b;
    const float twist = std::remainder(2 * std::atan2(turn.x(), turn.w()), 2 * static_cast<float>(M_PI));
    const float swing = std::acos(std::clamp((turn * Vector3f::UnitX()).x(), -1.0f, 1.0f));
    float room = std::min(twist - joint.limits.twist.lowest, joint.limits.twist.highest - twist);
    if (joint.limits.swing < static_cast<float>(M_PI)) room = std::min(room, joint.limits.swing - swing);
    return room;
}

TEST(SceneAnimation, LimitsTakeInTheRestPoseAndEveryPoseOfAClip)
{
    const World world = worldOf(figure(DANCE));
    uint32_t limited = 0;
    for (int k = -1; k < 160; ++k) {
        const double time = 0.05 * k;
        std::vector<Pose> poses(world.bodies.size());
        if (k >= 0) poses = bodyPlaces(world, world.animations[0], time);
        for (const Joint& joint : world.joints) {
            if (!joint.limits.any()) continue;
            ++limited;
            // 5 degrees at the keys; between keys splines overshoot a little.
            EXPECT_GT(roomOf(joint, poses[joint.parent].rotation, poses[joint.child].rotation), 0.07f)
                << joint.name << " at " << time << " s";
        }
    }
    EXPECT_EQ(limited, 161 * world.joints.size());
}

TEST(SceneAnimation, LimitsCanBeLeftOutAndAreWhereAFigureIsHeldTwice)
{
    for (const Joint& joint : worldOf(figure(R"(, "limits": false)")).joints) EXPECT_FALSE(joint.limits.any());
    for (const Body& body : worldOf(figure(R"(, "limits": false)")).bodies) EXPECT_TRUE(body.filtered.empty());
    for (const Joint& joint : worldOf(figure(R"(, "hold": ["hand.L", "hand.R"])")).joints)
        EXPECT_EQ(joint.limits.any(), joint.name != "hand.R") << joint.name;
    for (const Joint& joint : worldOf(figure(""), R"("solver": "paper", )").joints) EXPECT_FALSE(joint.limits.any());
}

TEST(SceneAnimation, ReleasesAreOfAllOrOfWhatHangsOnABody)
{
    const World whole = worldOf(figure(DANCE + R"(, "release": {"clipTime": 1.5})"));
    for (const Body& body : whole.bodies) EXPECT_EQ(body.releaseTime, 1.5f) << body.name;
    const World part = worldOf(
        figure(DANCE + R"(, "release": [{"time": 2, "below": "thigh.L"}, {"time": 3, "below": "spine"}])"));
    for (const Body& body : part.bodies) {
        const bool leg = body.name.ends_with(".L") && (body.name.starts_with("thigh") ||
                                                       body.name.starts_with("shin") || body.name.starts_with("foot"));
        const bool above = !leg && body.name != "hips" && !body.name.starts_with("thigh") &&
                           !body.name.starts_with("shin") && !body.name.starts_with("foot");
        if (leg) {
            EXPECT_EQ(body.releaseTime, 2.0f) << body.name;
        } else if (above) {
            EXPECT_EQ(body.releaseTime, 3.0f) << body.name;
        } else {
            EXPECT_TRUE(std::isinf(body.releaseTime)) << body.name;
        }
    }
}

TEST(SceneAnimation, APoseIsWhereALimpActorBegins)
{
    const World world = worldOf(figure(R"(, "pose": {"clip": "dance", "time": 1.3})"));
    const std::vector<Pose> wanted = bodyPlaces(world, world.animations[0], 0.0);
    float fastest = 0;
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        EXPECT_EQ(world.bodies[b].releaseTime, 0.0f);
        EXPECT_LT((world.bodies[b].position - wanted[b].translation).norm(), 1e-6f);
    }
    for (const Particle& particle : world.particles) fastest = std::max(fastest, particle.velocity.norm());
    EXPECT_GT(fastest, 0.2f);
    EXPECT_LT(fastest, 10.0f);
}

TEST(SceneAnimation, WhatDoesNotFitIsToldWithItsPlaceAndTheRemedy)
{
    const struct {
        std::string fields, complaint;
    } cases[] = {
        {R"(, "animation": {"clip": "dnace"})",
         "/objects/0/animation/clip: there is no clip \"dnace\"; did you mean \"dance\"?"},
        {R"(, "animation": {"file": "none.bvh"})", "/objects/0/animation/file: there is no file "},
        {R"(, "animation": {"clip": "dance", "speed": -1})", "/objects/0/animation/speed: -1 is below the minimum 0"},
        {R"(, "animation": {"clip": "dance", "then": [{"at": 2, "clip": "dance"}, {"at": 1, "clip": "dance"}]})",
         "/objects/0/animation/then/1/at: must not be before that of the entry before"},
        {DANCE + R"(, "velocity": [1, 0, 0])", "/objects/0/velocity: is what the clip says; take it away"},
        {DANCE + R"(, "fixed": true)", "/objects/0/animation: is for what is not held; take `fixed` and `hold` away"},
        {DANCE + R"(, "pose": {"clip": "dance"})",
         "/objects/0/pose: is where a limp actor begins; take it or `animation` away"},
        {DANCE + R"(, "release": {"time": 1, "below": "knee"})",
         "/objects/0/release/below: there is no body \"knee\"; "},
        {DANCE + R"(, "release": {"time": 1, "clipTime": 1})",
         "/objects/0/release: has `time` and `clipTime`; give one of them"},
        {DANCE + R"(, "release": {"clipTime": 9})",
         "/objects/0/release/clipTime: is a time that the first clip never gets to"},
        {R"(, "release": {"clipTime": 1})", "/objects/0/release/clipTime: is for what has an `animation`; give `time`"},
        {R"(, "release": [{"time": 1}])",
         "/objects/0/release/0: is for what is held or animated; set `fixed`, `hold` or `animation`, or take it away"},
    };
    for (const auto& wrong : cases)
        EXPECT_TRUE(complaintOf(figure(wrong.fields)).starts_with(wrong.complaint))
            << complaintOf(figure(wrong.fields));
    EXPECT_EQ(complaintOf(figure(DANCE), R"("solver": "paper", )"),
              "the paper's solver has no animation; take `animation` away, or use solver method impulse");
}

}  // namespace knuckle::test
