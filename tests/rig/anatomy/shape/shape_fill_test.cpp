#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

using Chains = std::vector<std::string>;

const std::map<std::string, BodyPart> PARTS = {
    {"hips", BodyPart::Hips},       {"spine", BodyPart::Spine},       {"neck", BodyPart::Neck},
    {"head", BodyPart::Head},       {"clavicle", BodyPart::Clavicle}, {"upperArm", BodyPart::UpperArm},
    {"forearm", BodyPart::Forearm}, {"hand", BodyPart::Hand},         {"thigh", BodyPart::Thigh},
    {"shin", BodyPart::Shin},       {"foot", BodyPart::Foot},         {"toe", BodyPart::Toe},
    {"finger", BodyPart::Finger},   {"attached", BodyPart::Other},
};

void expectRead(const Rig& rig)
{
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        EXPECT_EQ(anatomy[b].part, PARTS.at(rig.expected[b])) << rig.model.bones[b].name;
        EXPECT_EQ(anatomy[b].side, rig.sides[b]) << rig.model.bones[b].name;
    }
}

void expectRead(const std::string& left, const std::string& right, const Chains& chains)
{
    expectRead(makeRig({"", left, right, chains}));
}

}  // namespace

TEST(ShapeFill, OneLimbThatIsNamedLeavesTheOthersToTheShape)
{
    expectRead("L", "R",
               {"Becken=hips > Wirbel=spine > Brust=spine > Hals=neck > Kopf=head",
                "Brust > Schluesselbein.{}=clavicle > Oberarm.{}=upperArm > Unterarm.{}=forearm > Hand.{}=hand",
                "Becken > Oberschenkel.{}=thigh > Unterschenkel.{}=shin > Fuss.{}=foot > Zehen.{}=toe"});
    expectRead("L", "R",
               {"Hips=hips > Spine=spine > Chest=spine > Neck=neck > Head=head",
                "Chest > Sholder_{}=clavicle > UperArm_{}=upperArm > LowArm_{}=forearm > Hnd_{}=hand",
                "Hips > Tigh_{}=thigh > LowLeg_{}=shin > Fot_{}=foot"});
}

TEST(ShapeFill, ALimbThatIsNamedWithoutASideHasThatOfItsPlace)
{
    expectRead("v", "h",
               {"hoft=hips > rygg=spine > brost=spine > hals=neck > huvud=head",
                "brost > axel_{}=clavicle > overarm_{}=upperArm > underarm_{}=forearm > hand_{}=hand",
                "hoft > lar_{}=thigh > vad_{}=shin > fot_{}=foot > ta_{}=toe"});
}

TEST(ShapeFill, NamesSayWhichBoneOfALimbIsWhich)
{
    // By the number of its bones the first would be a collar bone, and so would the one after the hand.
    expectRead("L", "R",
               {"Hips=hips > Spine=spine > Neck=neck > Head=head", "Spine > Xa.{}=upperArm > Forearm.{}=forearm",
                "Forearm.{} > Xb.{}=hand > Xc.{}=finger", "Hips > Thigh.{}=thigh > Shin.{}=shin > Foot.{}=foot"});
}

TEST(ShapeFill, WhatIsCalledAttachedIsNoLimb)
{
    Rig rig = makeRig({"",
                       "L",
                       "R",
                       {"b0=hips > b1=spine > b2=spine > b3=neck > b4=head",
                        "b2 > c0.{}=clavicle > c1.{}=upperArm > c2.{}=forearm > c3.{}=hand",
                        "b0 > d0.{}=thigh > d1.{}=shin > d2.{}=foot > d3.{}=toe"}});
    for (const int side : {1, -1}) {
        auto parent = int32_t(rig.find("b2"));
        for (int i = 0; i < 6; ++i)
            parent = int32_t(rig.add("cape_" + std::to_string(i) + (side > 0 ? ".L" : ".R"), parent,
                                     {0.15f * float(side), 1.35f - 0.2f * float(i), -0.2f}, "attached", side));
    }
    expectRead(rig);
}

TEST(ShapeFill, AShapeThatContradictsNamesSaysNothing)
{
    const Rig rig = makeRig(
        {"",
         "L",
         "R",
         {"b0=hips > b1=spine > b2=spine > b3=neck > b4=head", "b2 > c0.{}=upperArm > thigh.{}=forearm > c2.{}=hand",
          "b0 > d0.{}=thigh > hand.{}=shin > d2.{}=foot"}});
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    EXPECT_EQ(std::ranges::count(anatomy, AnatomySource::Shape, &BoneAnatomy::source), 0);
}

TEST(ShapeFill, AShapeThatMissesWhatIsNamedSaysNothing)
{
    // Too short for arms.
    const Rig rig = makeRig(
        {"",
         "L",
         "R",
         {"b0=hips > b1=spine > b2=spine > b3=neck > b4=head", "b2 > thigh.{}=upperArm > shin.{}=forearm",
          "b0 > d0.{}=thigh > d1.{}=shin > d2.{}=foot"}});
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    EXPECT_EQ(std::ranges::count(anatomy, AnatomySource::Shape, &BoneAnatomy::source), 0);
}

}  // namespace knuckle::test
