#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/rig/joints/joint_ranges.h"
#include "sim/rig/joints/lasting_turns.h"

namespace knuckle::test {
namespace {

constexpr float RATE = 60.0f;

const Vector3f AXIS(0, -1, 0);

Quaternionf turn(float degrees, const Vector3f& axis)
{
    return Quaternionf(Eigen::AngleAxisf(degrees * DEGREE, axis));
}

/// A joint with limits of -10 to 100 degrees, or of 40 each way.
struct Limited {
    JointType type;
    JointLimits limits;
    Vector3f about;  ///< Axis of a turn beyond the limits.
    float end;       ///< End of the limits [degrees].
};

std::vector<Limited> limitedJoints()
{
    Limited hinge{JointType::Hinge, {}, AXIS, 100}, cone{JointType::Ball, {}, Vector3f::UnitX(), 40};
    hinge.limits.bend = {-10 * DEGREE, 100 * DEGREE};
    cone.limits.swing = 40 * DEGREE;
    cone.limits.twist = {-40 * DEGREE, 40 * DEGREE};
    Limited twist = cone, leaning = cone;
    twist.about = AXIS;
    leaning.limits.cone = turn(25, Vector3f::UnitX()) * AXIS;
    leaning.end = 65;
    return {hinge, cone, twist, leaning};
}

/// At rest for half a second, turned for some keys, at rest for half a second.
Turns excursion(const Limited& joint, float beyond, int keys)
{
    Turns turns(60 + keys, Quaternionf::Identity());
    std::fill_n(turns.begin() + 30, keys, turn(joint.end + beyond, joint.about));
    return turns;
}

LastingTurns lastingOf(const Limited& joint, const Turns& turns)
{
    return lastingTurns(joint.limits, joint.type, AXIS, turns, RATE);
}

/// How far the farthest of some turns exceeds the limits [degrees].
float farthest(const Limited& joint, const Turns& turns)
{
    float most = -1000;
    for (const Quaternionf& q : turns) most = std::max(most, q.angularDistance(Quaternionf::Identity()) / DEGREE);
    return most - joint.end;
}

TEST(LastingTurns, LeaveOutWhatIsFarOffForAMomentOrByFar)
{
    for (const Limited& joint : limitedJoints()) {
        for (const auto& [beyond, keys, lasts] :
             {std::tuple(18.0f, 1, true), {22.0f, 5, false}, {22.0f, 6, true}, {58.0f, 18, true}, {62.0f, 18, false}}) {
            const LastingTurns lasting = lastingOf(joint, excursion(joint, beyond, keys));
            EXPECT_EQ(lasting.parts.size(), lasts ? 1u : 2u) << joint.end << ": " << beyond << ", " << keys << " keys";
            EXPECT_NEAR(lasting.leftOut / DEGREE, lasts ? 0.0f : beyond, 0.1f);
        }
    }
}

TEST(LastingTurns, WhatPassesThroughOnItsWayByFarDoesNotLast)
{
    for (const Limited& joint : limitedJoints()) {
        Turns turns;
        for (int k = -50; k <= 50; ++k)
            turns.push_back(turn(joint.end + 80.0f - 2.0f * static_cast<float>(std::abs(k)), joint.about));
        for (const Turns& part : lastingOf(joint, turns).parts) EXPECT_LE(farthest(joint, part), 20.1f);
    }
}

TEST(LastingTurns, MomentsAreNotAddedUpAndTheOnlyKeyLasts)
{
    for (const Limited& joint : limitedJoints()) {
        Turns turns;
        for (int k = 0; k < 10; ++k) {
            const Turns more = excursion(joint, 40, 2);
            turns.insert(turns.end(), more.begin(), more.end());
        }
        EXPECT_NEAR(lastingOf(joint, turns).leftOut / DEGREE, 40, 0.1f);
        EXPECT_EQ(lastingOf(joint, {turn(joint.end + 40, joint.about)}).leftOut, 0.0f);
    }
}

TEST(HeldTurns, AreWithinTheLimitsWithSomeToSpareAndNothingJerks)
{
    for (const Limited& joint : limitedJoints()) {
        for (const int keys : {1, 4, 40}) {
            const Turns turns = excursion(joint, 70, keys);
            const Turns held = heldTurns(joint.limits, joint.type, AXIS, turns, RATE);
            ASSERT_EQ(held.size(), turns.size());
            EXPECT_LE(farthest(joint, held), -4.9f);
            EXPECT_GE(farthest(joint, held), keys == 40 ? -5.1f : -joint.end) << "it goes to the limit";
            for (size_t k = 1; k < held.size(); ++k)
                EXPECT_LT(held[k].angularDistance(held[k - 1]), 0.25f * joint.end * DEGREE) << keys << ", key " << k;
            for (const size_t k : {size_t{0}, size_t{20}, turns.size() - 20, turns.size() - 1})
                EXPECT_EQ(held[k].coeffs(), turns[k].coeffs()) << "what is not near stays as it is";
        }
    }
}

TEST(HeldTurns, StayAsTheyAreWhereTheyFit)
{
    for (const Limited& joint : limitedJoints()) {
        const Turns turns = excursion(joint, -6, 20);
        const Turns held = heldTurns(joint.limits, joint.type, AXIS, turns, RATE);
        for (size_t k = 0; k < turns.size(); ++k) EXPECT_EQ(held[k].coeffs(), turns[k].coeffs());
    }
}

/// An elbow that spins stays at its end until it is back in its range.
TEST(HeldTurns, WhatGoesRoundComesBack)
{
    const Limited hinge = limitedJoints()[0];
    Turns turns;
    for (int k = 0; k <= 120; ++k) turns.push_back(turn(6.0f * static_cast<float>(k), AXIS));
    const Turns held = heldTurns(hinge.limits, hinge.type, AXIS, turns, RATE);
    EXPECT_NEAR(held[40].angularDistance(Quaternionf::Identity()) / DEGREE, 95, 0.1f);
    EXPECT_NEAR(held[68].angularDistance(Quaternionf::Identity()) / DEGREE, 48, 10.0f);
    EXPECT_NEAR(held[100].angularDistance(Quaternionf::Identity()) / DEGREE, 95, 0.1f);
}

}  // namespace
}  // namespace knuckle::test
