#include <gtest/gtest.h>

#include <cmath>

#include "sim/rig/joints/fold.h"

namespace knuckle::test {

namespace {

const Vector3f FORWARD(0, 0, 1), DOWN(0, -1, 0);

/// A limb below a straight one, bent forward by this angle.
LimbStance bent(BodyPart part, float degrees, bool upright)
{
    LimbStance limb{.part = part, .above = DOWN, .upright = upright};
    limb.along = {0, -std::cos(degrees * DEGREE), std::sin(degrees * DEGREE)};
    return limb;
}

/// A clip that bends a limb from one angle to another, forward.
std::vector<Turns> bending(float from, float to)
{
    Turns turns;
    for (int i = 0; i <= 10; ++i)
        turns.emplace_back(Eigen::AngleAxisf(-(from + (to - from) * 0.1f * float(i)) * DEGREE, Vector3f::UnitX()));
    return {turns};
}

}  // namespace

TEST(Fold, KneesFoldBackElbowsForwardAndFingersToThePalm)
{
    EXPECT_LT(foldDirection(bent(BodyPart::Shin, 0, true), {}).dot(FORWARD), -0.99f);
    EXPECT_GT(foldDirection(bent(BodyPart::Forearm, 0, true), {}).dot(FORWARD), 0.99f);
    const LimbStance level{.part = BodyPart::Finger, .above = {1, 0, 0}, .along = {1, 0, 0}};
    EXPECT_GT(foldDirection(level, {}).dot(DOWN), 0.99f);
    const LimbStance hanging{.part = BodyPart::Finger, .above = DOWN, .along = DOWN};
    EXPECT_LT(foldDirection(hanging, {}).x(), -0.99f);
    const LimbStance raised{.part = BodyPart::Finger, .above = -DOWN, .along = -DOWN, .outward = {0, 0, 0}};
    EXPECT_GT(foldDirection(raised, {}).dot(FORWARD), 0.99f) << "of a hand alone, which has no side";
}

TEST(Fold, AKneeThatIsBentForwardIsAnErrorUnlessItIsBentMuchOrACreatures)
{
    EXPECT_LT(foldDirection(bent(BodyPart::Shin, 15, true), {}).z(), -0.9f);
    EXPECT_GT(foldDirection(bent(BodyPart::Shin, 40, true), {}).z(), 0.7f);
    EXPECT_GT(foldDirection(bent(BodyPart::Shin, 15, false), {}).z(), 0.9f);
}

TEST(Fold, WhatClipsDoWinsOverEverything)
{
    const LimbStance straight = bent(BodyPart::Forearm, 0, false), back = bent(BodyPart::Forearm, -15, true);
    EXPECT_LT(foldDirection(straight, bending(0, -60)).z(), -0.99f);
    EXPECT_GT(foldDirection(back, bending(0, 80)).z(), 0.9f);
    // Bends of equal size both ways tell nothing, and so do small ones.
    EXPECT_GT(foldDirection(straight, bending(-60, 60)).z(), 0.99f);
    EXPECT_GT(foldDirection(straight, bending(0, -10)).z(), 0.99f);
}

TEST(Fold, ABendIsMeasuredTheWayThatALimbFolds)
{
    const LimbStance limb = bent(BodyPart::Forearm, 40, true);
    const Vector3f axis = limb.along.cross(foldDirection(limb, {}));
    EXPECT_NEAR(restBend(limb, axis), 40 * DEGREE, 1e-4f);
    EXPECT_NEAR(restBend(limb, -axis), -40 * DEGREE, 1e-4f);
}

TEST(Fold, WhatIsBentFarAtRestFoldsFarther)
{
    for (const BodyPart part : {BodyPart::Shin, BodyPart::Forearm}) {
        for (const float degrees : {60.0f, 90.0f, 100.0f, 130.0f, 160.0f}) {
            for (const float way : {1.0f, -1.0f}) {
                const LimbStance limb = bent(part, way * degrees, true);
                const Vector3f axis = limb.along.cross(foldDirection(limb, {}));
                EXPECT_LT((axis + way * Vector3f::UnitX()).norm(), 1e-4f) << way * degrees;
                EXPECT_NEAR(restBend(limb, axis), degrees * DEGREE, 1e-4f) << way * degrees;
            }
        }
    }
}

TEST(Fold, LeversTurnInTheirUprightPlane)
{
    const Vector3f x(1, 0, 0);
    for (const Vector3f& along : {Vector3f(0, 0, 1), Vector3f(0, 1, 0), Vector3f(0, -0.8f, 0.6f)}) {
        const LimbStance lever{.part = BodyPart::Lever, .along = along};
        EXPECT_GT(std::abs(along.cross(foldDirection(lever, {})).dot(x)), 0.99f);
    }
    // A limb that is bent at rest shows its plane.
    const LimbStance bent{.part = BodyPart::Lever, .above = {0, 1, 0}, .along = Vector3f(1, 3, 0).normalized()};
    EXPECT_GT(std::abs(bent.along.cross(foldDirection(bent, {})).z()), 0.99f);
}

}  // namespace knuckle::test
