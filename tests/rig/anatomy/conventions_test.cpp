#include <gtest/gtest.h>

#include <cctype>
#include <map>

#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

const std::map<std::string, BodyPart> PARTS = {
    {"hips", BodyPart::Hips},       {"spine", BodyPart::Spine},       {"neck", BodyPart::Neck},
    {"head", BodyPart::Head},       {"clavicle", BodyPart::Clavicle}, {"upperArm", BodyPart::UpperArm},
    {"forearm", BodyPart::Forearm}, {"hand", BodyPart::Hand},         {"finger", BodyPart::Finger},
    {"thigh", BodyPart::Thigh},     {"shin", BodyPart::Shin},         {"foot", BodyPart::Foot},
    {"toe", BodyPart::Toe},
};

const std::map<std::string, BoneRole> ROLES = {
    {"twist", BoneRole::Twist}, {"attached", BoneRole::Attached}, {"control", BoneRole::Control}};

class Conventions : public testing::TestWithParam<Convention> {};

std::string testName(const testing::TestParamInfo<Convention>& info)
{
    std::string name = info.param.name;
    std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
    return name;
}

}  // namespace

TEST_P(Conventions, EveryBoneIsWhatItsNameSays)
{
    const Rig rig = makeRig(GetParam());
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        const std::string &name = rig.model.bones[b].name, &is = rig.expected[b];
        const auto role = ROLES.find(is);
        EXPECT_EQ(anatomy[b].role, role == ROLES.end() ? BoneRole::Limb : role->second) << name;
        if (const auto part = PARTS.find(is); part != PARTS.end()) {
            EXPECT_EQ(anatomy[b].part, part->second) << name;
            EXPECT_EQ(anatomy[b].side, rig.sides[b]) << name;
            EXPECT_EQ(anatomy[b].source, AnatomySource::Name) << name;
        }
        ASSERT_LT(anatomy[b].owner, anatomy.size()) << name;
        if (is == "attached" && rig.model.bones[b].name.find("pelvis") != std::string::npos) {
            EXPECT_EQ(anatomy[anatomy[b].owner].part, BodyPart::Hips) << name;
        }
        if (is == "twist") {
            EXPECT_EQ(rig.sides[anatomy[b].owner], rig.sides[b]) << name;
        }
    }
}

TEST_P(Conventions, LimbsHangTogether)
{
    const Rig rig = makeRig(GetParam());
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    const std::map<BodyPart, BodyPart> above = {
        {BodyPart::Shin, BodyPart::Thigh},   {BodyPart::Foot, BodyPart::Shin},  {BodyPart::Forearm, BodyPart::UpperArm},
        {BodyPart::Hand, BodyPart::Forearm}, {BodyPart::Thigh, BodyPart::Hips}, {BodyPart::Clavicle, BodyPart::Spine}};
    std::map<BodyPart, int> counts;
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        if (anatomy[b].role != BoneRole::Limb) continue;
        ++counts[anatomy[b].part];
        if (anatomy[b].part == BodyPart::UpperArm && counts.contains(BodyPart::Clavicle)) {
            EXPECT_EQ(anatomy[anatomy[b].parent].part, BodyPart::Clavicle) << rig.model.bones[b].name;
        }
        const auto wanted = above.find(anatomy[b].part);
        if (wanted == above.end()) continue;
        ASSERT_GE(anatomy[b].parent, 0) << rig.model.bones[b].name;
        EXPECT_EQ(anatomy[anatomy[b].parent].part, wanted->second) << rig.model.bones[b].name;
        const int side = anatomy[anatomy[b].parent].side;
        EXPECT_TRUE(side == anatomy[b].side || side == 0) << rig.model.bones[b].name;
    }
    for (const BodyPart part :
         {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand, BodyPart::Thigh, BodyPart::Shin, BodyPart::Foot})
        EXPECT_EQ(counts[part], 2);
}

INSTANTIATE_TEST_SUITE_P(All, Conventions, testing::ValuesIn(conventions()), testName);

TEST(JointTypes, KneesAndElbowsAreHingesHipsAndShouldersBalls)
{
    for (const BodyPart part : {BodyPart::Forearm, BodyPart::Shin, BodyPart::Finger, BodyPart::Toe})
        EXPECT_EQ(jointTypeOf(part), JointType::Hinge);
    for (const BodyPart part : {BodyPart::UpperArm, BodyPart::Thigh, BodyPart::Hand, BodyPart::Foot, BodyPart::Head,
                                BodyPart::Tail, BodyPart::Wing, BodyPart::Other})
        EXPECT_EQ(jointTypeOf(part), JointType::Ball);
    for (const BodyPart part : {BodyPart::Spine, BodyPart::Neck, BodyPart::Clavicle, BodyPart::Hips})
        EXPECT_EQ(jointTypeOf(part), JointType::Stiff);
}

}  // namespace knuckle::test
