#include <gtest/gtest.h>

#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

using Eigen::Vector3f;

Rig figure()
{
    return makeRig({"figure",
                    "l",
                    "r",
                    {"pelvis=hips > spine_01=spine > spine_02=spine > neck=neck > head=head",
                     "spine_02 > clavicle_{}=clavicle > upperarm_{}=upperArm > forearm_{}=forearm > hand_{}=hand",
                     "pelvis > thigh_{}=thigh > shin_{}=shin > foot_{}=foot > toe_{}=toe"}});
}

Vector3f leftOf(const Rig& rig)
{
    return knuckle::leftOf(rig.model, readAnatomy(rig.model));
}

void move(Rig& rig, const std::string& bone, const Vector3f& way)
{
    rig.model.bones[rig.find(bone)].restPose.block<3, 1>(0, 3) += way;
}

}  // namespace

TEST(Bearings, APoseDoesNotTurnWhereAFigureLooks)
{
    Rig rig = figure();
    EXPECT_LT((leftOf(rig) - Vector3f::UnitX()).norm(), 1e-5f);
    for (const char* bone : {"shin_l", "foot_l", "toe_l"}) move(rig, bone, {0, 0, 0.4f});
    for (const char* bone : {"forearm_r", "hand_r"}) move(rig, bone, {0.3f, 0, 0.5f});
    EXPECT_LT((leftOf(rig) - Vector3f::UnitX()).norm(), 1e-5f);
}

TEST(Bearings, WhatHangsOnOneSideDoesNotEither)
{
    Rig rig = figure();
    auto parent = int32_t(rig.find("clavicle_l"));
    for (int i = 0; i < 10; ++i)
        parent = int32_t(rig.add("thread_l_" + std::to_string(i), parent, {0.15f, 1.4f, -0.2f * float(i)}, "", 1));
    rig.add("sword_l", int32_t(rig.find("hand_l")), {0.7f, 1.4f, 0.8f}, "", 1);
    EXPECT_LT((leftOf(rig) - Vector3f::UnitX()).norm(), 1e-5f);
}

TEST(Bearings, WithoutHipsAndShouldersOtherPairsSayIt)
{
    Rig rig;
    const auto body = int32_t(rig.add("body", -1, {0, 1, 0}));
    rig.add("flap_l", body, {0, 1, -0.5f}, "", 1);
    rig.add("flap_r", body, {0, 1, 0.5f}, "", -1);
    EXPECT_LT((leftOf(rig) + Vector3f::UnitZ()).norm(), 1e-5f);
    rig.add("fan_r", body, {3, 1, 0.5f}, "", -1);
    EXPECT_LT((leftOf(rig) - Vector3f::UnitX()).norm(), 1e-5f) << "nobody knows which are pairs";
}

}  // namespace knuckle::test
