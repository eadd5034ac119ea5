#include <gtest/gtest.h>

#include "sim/rig/anatomy/names/bone_name.h"
#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

using Words = std::vector<std::string>;

/// The anatomy of a bone that hangs on the hips of a figure, beside its limbs.
BoneAnatomy onHips(const std::string& name)
{
    Rig rig = makeRig(conventions().front());
    const uint32_t bone = rig.add(name, 0, {0, 1, 0});
    return readAnatomy(rig.model)[bone];
}

}  // namespace

TEST(BoneNames, AreTakenApartIntoWords)
{
    EXPECT_EQ(wordsOf("mixamorig:LeftUpLeg"), (Words{"left", "up", "leg"}));
    EXPECT_EQ(wordsOf("group|rig:Bip01 L Calf"), (Words{"bip", "l", "calf"}));
    EXPECT_EQ(wordsOf("LHipJoint"), (Words{"l", "hip", "joint"}));
    EXPECT_EQ(wordsOf("lhipjoint"), (Words{"l", "hip", "joint"}));
    EXPECT_EQ(wordsOf("upperarm_twist_01_l"), (Words{"upper", "arm", "twist", "l"}));
    EXPECT_EQ(wordsOf("DEF-forearm.L.001"), (Words{"def", "forearm", "l"}));
    EXPECT_EQ(wordsOf("mHandMiddle1Left"), (Words{"m", "hand", "middle", "left"}));
    EXPECT_EQ(wordsOf("rightShoulder"), (Words{"right", "shoulder"}));
    EXPECT_EQ(wordsOf("IKFootL"), (Words{"ik", "foot", "l"}));
    EXPECT_EQ(wordsOf("左足首"), (Words{"left", "ankle"}));
    EXPECT_EQ(wordsOf("nodes[8]"), (Words{"nodes"}));
    EXPECT_TRUE(wordsOf("123 :").empty());
}

TEST(BoneNames, SaySides)
{
    for (const char* left : {"LeftArm", "arm.L", "arm_l", "Arm L", "l_arm", "lArm", "larm", "armLeft", "arm.l.001",
                             "mHipLeft", "LHipJoint", "J_Bip_L_Hand", "lf_arm", "LEFT_ARM", "左腕", "b_LeftLeg01_015"})
        EXPECT_EQ(readBoneName(left).side, 1) << left;
    for (const char* right : {"RightArm", "arm.R", "R_Hip", "rfemur", "RThumb", "Bip01 R Thigh", "右ひざ"})
        EXPECT_EQ(readBoneName(right).side, -1) << right;
    for (const char* neither : {"Hips", "lowerback", "root", "leg", "rear", "lip", "Spine1", "rib", "ring", "legacy"})
        EXPECT_EQ(readBoneName(neither).side, 0) << neither;
}

TEST(BoneNames, LettersInsideOtherWordsMeanNothing)
{
    for (const char* name : {"harm", "legacy", "handle", "harmonica", "string", "spring", "sleg", "charm", "footer",
                             "headlight", "toenailed", "middle", "bone.L", "swinging", "legend"})
        EXPECT_EQ(onHips(name).part, BodyPart::Other) << name;
}

TEST(BoneNames, AMiddleSpineIsASpine)
{
    for (const char* name : {"middle spine", "SpineMiddle", "spine_mid", "lower_back", "Back", "body"})
        EXPECT_EQ(onHips(name).part, BodyPart::Spine) << name;
}

TEST(BoneNames, WhatIsWornOrCarriedStaysOnItsBone)
{
    for (const char* name :
         {"armour.L", "earring.R", "shinGuard.L", "knee_pad_l", "headband", "SkirtBack", "hand_bag", "bowstring",
          "foot armor", "LeftShoulderPad", "weapon_r", "Ponytail2", "L_Breast", "jaw_l", "chest_strap"}) {
        EXPECT_EQ(onHips(name).role, BoneRole::Attached) << name;
        EXPECT_EQ(onHips(name).part, BodyPart::Other) << name;
        EXPECT_EQ(onHips(name).owner, 0u) << name;
    }
}

TEST(BoneNames, ABigToeIsNoFinger)
{
    for (const char* name : {"LeftFootThumb1", "l_toe_index", "lBigToe2", "R_FootPinky"})
        EXPECT_EQ(readBoneName(name).part, NamedPart::Toe) << name;
}

}  // namespace knuckle::test
