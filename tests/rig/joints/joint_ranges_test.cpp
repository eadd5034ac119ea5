#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "sim/rig/joints/joint_ranges.h"

namespace knuckle::test {

namespace {

Quaternionf turn(float degrees, const Vector3f& axis)
{
    return Quaternionf(Eigen::AngleAxisf(degrees * DEGREE, axis));
}

}  // namespace

TEST(JointRanges, AKneeBendsOneWayFromStraight)
{
    // Bent by 10 degrees at rest: 10 to straight, 130 to the end of its range.
    const JointLimits knee = ordinaryRange({.part = BodyPart::Shin, .bend = 10 * DEGREE});
    EXPECT_NEAR(knee.bend.lowest, -10 * DEGREE, 1e-5f);
    EXPECT_NEAR(knee.bend.highest, 130 * DEGREE, 1e-5f);
    // Straight at rest: 5 degrees to spare.
    EXPECT_NEAR(ordinaryRange({.part = BodyPart::Shin}).bend.lowest, -5 * DEGREE, 1e-5f);
}

TEST(JointRanges, ASpineSharesItsRangeAmongItsSegments)
{
    const LimbStance up{.part = BodyPart::Spine, .along = {0, 1, 0}};
    LimbStance third = up;
    third.segments = 3;
    EXPECT_NEAR(ordinaryRange(up).twist.highest, 45 * DEGREE, 1e-5f);
    EXPECT_NEAR(ordinaryRange(third).twist.highest, 15 * DEGREE, 1e-5f);
    EXPECT_LT(ordinaryRange(third).swing, ordinaryRange(up).swing);
}

TEST(JointRanges, AHipLetsItsThighForwardFurtherThanBack)
{
    const JointLimits hip = ordinaryRange({.part = BodyPart::Thigh});
    const auto lets = [&](const Vector3f& along) {
        return hip.cone.normalized().dot(along.normalized()) > std::cos(hip.swing);
    };
    EXPECT_TRUE(lets({0, 0, 1}));
    EXPECT_TRUE(lets({1, -1, 0}));
    EXPECT_TRUE(lets({0, -0.87f, -0.5f}));
    EXPECT_FALSE(lets({0, -0.5f, -0.87f}));
    EXPECT_FALSE(lets({0, 1, 0}));
}

TEST(JointRanges, WhatAClipDoesIsTakenInWithFiveDegreesToSpare)
{
    JointLimits hinge;
    hinge.bend = {-0.1f, 1.0f};
    takeIn(hinge, JointType::Hinge, {0, 0, 1}, std::array{turn(40, {0, 0, 1})});
    EXPECT_EQ(hinge.bend.highest, 1.0f);
    takeIn(hinge, JointType::Hinge, {0, 0, 1}, std::array{turn(-60, {0, 0, 1})});
    EXPECT_NEAR(hinge.bend.lowest, -65 * DEGREE, 1e-5f);

    JointLimits ball;
    ball.swing = 20 * DEGREE;
    ball.twist = {-10 * DEGREE, 10 * DEGREE};
    takeIn(ball, JointType::Ball, {0, 1, 0}, std::array{turn(50, {1, 0, 0}) * turn(30, {0, 1, 0})});
    EXPECT_NEAR(ball.swing, 55 * DEGREE, 1e-5f);
    EXPECT_NEAR(ball.twist.highest, 35 * DEGREE, 1e-5f);
    EXPECT_NEAR(ball.twist.lowest, -10 * DEGREE, 1e-5f);
    takeIn(ball, JointType::Ball, {0, 1, 0}, std::array{turn(178, {1, 0, 0})});
    EXPECT_EQ(ball.swing, static_cast<float>(M_PI)) << "all the way round is no limit";
}

/// A joint that bends about x and runs down y, after ranges of less than 5 degrees are locked [degrees].
JointPlan locked(JointType type, TurnRange bend, TurnRange second, float swing, TurnRange twist)
{
    const auto radians = [](TurnRange range) { return TurnRange{range.lowest * DEGREE, range.highest * DEGREE}; };
    JointPlan plan{.type = type, .axis = {1, 0, 0}};
    plan.limits = {
        .swing = swing * DEGREE, .twist = radians(twist), .bend = radians(bend), .secondBend = radians(second)};
    lockNarrowRanges(plan);
    return plan;
}

TEST(JointRanges, LessThanFiveDegreesIsALockedAxis)
{
    constexpr TurnRange FREE{-180, 180}, NARROW{-2, 2.9f}, WIDE{-2, 3.1f}, ELSEWHERE{10, 12};
    EXPECT_EQ(locked(JointType::Hinge, NARROW, FREE, 180, FREE).type, JointType::Stiff);
    EXPECT_FALSE(locked(JointType::Hinge, NARROW, FREE, 180, FREE).limits.any());
    for (const TurnRange& range : {WIDE, ELSEWHERE, FREE})
        EXPECT_EQ(locked(JointType::Hinge, range, FREE, 180, FREE).type, JointType::Hinge);

    EXPECT_EQ(locked(JointType::Ball, FREE, FREE, 2.4f, NARROW).type, JointType::Stiff);
    EXPECT_EQ(locked(JointType::Ball, FREE, FREE, 2.6f, NARROW).type, JointType::Ball);
    const JointPlan twists = locked(JointType::Ball, FREE, FREE, 2.4f, {-30, 40});
    EXPECT_EQ(twists.type, JointType::Hinge);
    EXPECT_LT((twists.axis - Vector3f(0, -1, 0)).norm(), 1e-6f);
    EXPECT_LT(std::abs(twists.along.dot(twists.axis)), 1e-6f);
    EXPECT_NEAR(twists.limits.bend.highest, 40 * DEGREE, 1e-6f);

    EXPECT_EQ(locked(JointType::Universal, NARROW, NARROW, 180, FREE).type, JointType::Stiff);
    const JointPlan first = locked(JointType::Universal, {-30, 30}, NARROW, 180, FREE);
    const JointPlan second = locked(JointType::Universal, NARROW, {-30, 20}, 180, FREE);
    EXPECT_EQ(first.type, JointType::Hinge);
    EXPECT_LT((first.axis - Vector3f(1, 0, 0)).norm(), 1e-6f);
    EXPECT_EQ(second.type, JointType::Hinge);
    // The axis at the child is perpendicular to the first one and to the limb.
    EXPECT_LT((second.axis - Vector3f(0, 0, 1)).norm(), 1e-6f);
    EXPECT_NEAR(second.limits.bend.highest, 20 * DEGREE, 1e-6f);

    JointPlan springy{.type = JointType::Hinge};
    springy.limits.bend = {-0.01f, 0.01f};
    springy.limits.stiffness = 50;
    lockNarrowRanges(springy);
    EXPECT_EQ(springy.type, JointType::Hinge) << "a spring behind a limit is to be felt";
}

/// Turns about z, in steps of 30 degrees.
std::vector<Quaternionf> turning(float from, float to)
{
    std::vector<Quaternionf> turns;
    const float step = to > from ? 30.0f : -30.0f;
    for (float degrees = from; (to - degrees) * step >= 0.0f; degrees += step)
        turns.push_back(turn(degrees, {0, 0, 1}));
    return turns;
}

TEST(JointRanges, OnlyWhatGoesRoundInAClipHasNoLimits)
{
    const auto after = [](const std::vector<Quaternionf>& turns) {
        JointLimits elbow;
        elbow.bend = {-5 * DEGREE, 146 * DEGREE};
        takeIn(elbow, JointType::Hinge, {0, 0, 1}, turns);
        return elbow.bend;
    };
    // -175 degrees are 185 for an elbow: a little more than its range.
    EXPECT_NEAR(after({turn(-175, {0, 0, 1})}).lowest, -5 * DEGREE, 1e-5f);
    EXPECT_NEAR(after({turn(-175, {0, 0, 1})}).highest, 175 * DEGREE, 1e-5f);
    EXPECT_NEAR(after(turning(0, 150)).highest, 155 * DEGREE, 1e-4f);
    EXPECT_NEAR(after(turning(0, 240)).highest, 175 * DEGREE, 1e-5f);
    EXPECT_NEAR(after(turning(0, 240)).lowest, -5 * DEGREE, 1e-5f);
    EXPECT_FALSE(after(turning(0, 360)).bounded());
    EXPECT_FALSE(after(turning(180, -180)).bounded());
    // A swing of half a turn does not determine the turn about the axis.
    EXPECT_NEAR(after({turn(178, {1, 0.02f, 0.02f})}).highest, 146 * DEGREE, 1e-5f);
}

TEST(JointRanges, AConeLeansToWhereAClipGoes)
{
    JointLimits paw;
    paw.swing = 40 * DEGREE;
    const Vector3f down(0, -1, 0);
    leanTo(paw, down, std::array{turn(30, {1, 0, 0})});
    EXPECT_NEAR(paw.swing, 40 * DEGREE, 1e-5f);
    EXPECT_TRUE(paw.cone.isZero());
    leanTo(paw, down, std::array{turn(95, {1, 0, 0})});
    // From 40 on the one side to 100 on the other.
    EXPECT_NEAR(paw.swing, 70 * DEGREE, 1e-4f);
    EXPECT_LT((paw.cone - turn(30, {1, 0, 0}) * down).norm(), 1e-4f);
}

TEST(JointRanges, OfAHingeThatOnlyClipsShowTheyAreTheRange)
{
    const Vector3f z(0, 0, 1);
    const std::vector<std::vector<Quaternionf>> lid{turning(0, 60), turning(0, -30)}, wheel{turning(0, 300)};
    const TurnRange opens = rangeInClips(z, lid).bend;
    EXPECT_NEAR(opens.lowest, -50 * DEGREE, 1e-4f);
    EXPECT_NEAR(opens.highest, 80 * DEGREE, 1e-4f);
    EXPECT_FALSE(rangeInClips(z, wheel).any());
}

TEST(JointRanges, ACreaturesLegsSwingAboutWhereTheyAre)
{
    const Vector3f along = Vector3f(0, -1, 0.8f).normalized();
    const JointLimits leg = ordinaryRange({.part = BodyPart::UpperArm, .along = along, .upright = false});
    EXPECT_LT((leg.cone - along).norm(), 1e-5f);
    EXPECT_NEAR(leg.swing, 50 * DEGREE, 1e-5f);
    // A knee bent by 62 degrees stretches half way; one bent by 120 folds 40 more.
    const auto knee = [](float bend) {
        return ordinaryRange({.part = BodyPart::Shin, .bend = bend * DEGREE, .upright = false}).bend;
    };
    EXPECT_NEAR(knee(62).lowest, -31 * DEGREE, 1e-5f);
    EXPECT_NEAR(knee(62).highest, 78 * DEGREE, 1e-5f);
    EXPECT_NEAR(knee(120).highest, 40 * DEGREE, 1e-5f);
    EXPECT_NEAR(knee(0).lowest, -5 * DEGREE, 1e-5f);
}

TEST(JointRanges, WhatIsNoPartOfABodyHasNone)
{
    for (const BodyPart part : {BodyPart::Other, BodyPart::Hips}) {
        EXPECT_FALSE(hasRange(part));
        EXPECT_FALSE(ordinaryRange({.part = part}).any());
    }
}

}  // namespace knuckle::test
