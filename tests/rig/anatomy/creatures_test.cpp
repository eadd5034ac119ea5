#include <gtest/gtest.h>

#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

using Eigen::Vector3f;

/// Adds the bones of legs on both sides of their carrier, by the heads of the left one. Names have {} for the side.
void addLegs(Rig& rig, int32_t carrier, const std::vector<std::string>& names, const Vector3f& from)
{
    for (const int side : {1, -1}) {
        int32_t parent = carrier;
        Vector3f head(float(side) * from.x(), from.y(), from.z());
        for (std::string name : names) {
            name.replace(name.find("{}"), 2, side > 0 ? "L" : "R");
            parent = int32_t(rig.add(name, parent, head, "", side));
            head.y() -= from.y() / float(names.size());
        }
    }
}

/// Looks along +z.
Rig quadruped(const std::vector<std::string>& front, const std::vector<std::string>& back)
{
    Rig rig;
    const auto hips = int32_t(rig.add("hips", -1, {0, 0.5f, -0.3f}));
    addLegs(rig, hips, back, {0.1f, 0.48f, -0.3f});
    const auto chest = int32_t(rig.add("chest", int32_t(rig.add("spine", hips, {0, 0.52f, 0})), {0, 0.52f, 0.2f}));
    addLegs(rig, chest, front, {0.1f, 0.48f, 0.3f});
    rig.add("head", int32_t(rig.add("neck", chest, {0, 0.6f, 0.4f})), {0, 0.7f, 0.5f});
    return rig;
}

std::vector<BodyPart> partsOf(const Rig& rig, std::vector<std::string> names)
{
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    std::vector<BodyPart> parts;
    for (std::string& name : names) {
        name.replace(name.find("{}"), 2, "R");
        const BoneAnatomy& bone = anatomy[rig.find(name)];
        EXPECT_EQ(bone.side, -1) << name;
        EXPECT_EQ(bone.role, BoneRole::Limb) << name;
        parts.push_back(bone.part);
    }
    return parts;
}

using Parts = std::vector<BodyPart>;
using Names = std::vector<std::string>;

const Parts LEG = {BodyPart::Thigh, BodyPart::Shin, BodyPart::Foot};
const Parts ARM = {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand};

}  // namespace

TEST(Creatures, OfFourLegsTheFrontOnesAreArms)
{
    const std::vector<std::pair<Names, Names>> rigs = {
        {{"front_upper_leg.{}", "front_lower_leg.{}", "front_foot.{}"},
         {"back_upper_leg.{}", "back_lower_leg.{}", "back_foot.{}"}},
        {{"frontThigh{}", "frontShin{}", "frontPaw{}"}, {"backThigh{}", "backShin{}", "backPaw{}"}},
        {{"foreleg1_{}", "foreleg2_{}", "forehoof_{}"}, {"hindleg1_{}", "hindleg2_{}", "hindhoof_{}"}},
        {{"upperArm_{}", "foreArm_{}", "front_paw_{}"}, {"Thigh_{}", "Calf_{}", "rear_paw_{}"}}};
    for (const auto& [front, back] : rigs) {
        const Rig rig = quadruped(front, back);
        EXPECT_EQ(partsOf(rig, front), ARM) << front[0];
        EXPECT_EQ(partsOf(rig, back), LEG) << back[0];
        EXPECT_FALSE(isUpright(rig.model, readAnatomy(rig.model))) << front[0];
    }
}

TEST(Creatures, AShoulderAboveAFrontLegIsItsBlade)
{
    const Names front = {"front_shoulder.{}", "front_upper_leg.{}", "front_lower_leg.{}", "front_foot.{}"};
    const Rig rig = quadruped(front, {"back_upper_leg.{}", "back_lower_leg.{}", "back_foot.{}"});
    EXPECT_EQ(partsOf(rig, front), Parts({BodyPart::Clavicle, ARM[0], ARM[1], ARM[2]}));
    const Names shorter = {"front_shoulder.{}", "front_leg.{}", "front_foot.{}"};
    EXPECT_EQ(partsOf(quadruped(shorter, {"back_hip.{}", "back_leg.{}", "back_foot.{}"}), shorter), ARM);
}

TEST(Creatures, SidesMayBeSaidTogetherWithFrontAndBack)
{
    Rig rig;
    const auto hips = int32_t(rig.add("pelvis", -1, {0, 0.5f, 0}));
    for (const char* corner : {"FL", "FR", "BL", "BR"}) {
        const float x = corner[1] == 'L' ? 0.1f : -0.1f, z = corner[0] == 'F' ? 0.3f : -0.3f;
        const auto top = int32_t(rig.add(std::string("upperLeg_") + corner, hips, {x, 0.45f, z}));
        rig.add(std::string("lowerLeg_") + corner, top, {x, 0.2f, z});
    }
    rig.add("head", hips, {0, 0.6f, 0.5f});
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    EXPECT_EQ(anatomy[rig.find("upperLeg_FL")].part, BodyPart::UpperArm);
    EXPECT_EQ(anatomy[rig.find("lowerLeg_BR")].part, BodyPart::Shin);
    EXPECT_EQ(anatomy[rig.find("upperLeg_BL")].side, 1);
    EXPECT_EQ(anatomy[rig.find("lowerLeg_FR")].side, -1);
}

TEST(Creatures, BackAtALegIsAPlaceAndNoSpine)
{
    const Names back = {"back_coxa.{}", "back_femur.{}", "back_tibia.{}"};
    Rig rig;
    const auto body = int32_t(rig.add("body", -1, {0, 0.3f, 0}));
    for (const char* place : {"front", "middle", "rear"}) {
        Names names = back;
        for (std::string& name : names) name.replace(0, 4, place);
        addLegs(rig, body, names, {0.2f, 0.3f, place[0] == 'f' ? 0.2f : 0.0f});
    }
    addLegs(rig, body, back, {0.2f, 0.3f, -0.3f});
    addLegs(rig, body, {"back_stinger.{}"}, {0.1f, 0.3f, -0.4f});
    EXPECT_EQ(partsOf(rig, back), Parts({BodyPart::Coxa, BodyPart::Thigh, BodyPart::Shin}));
    EXPECT_EQ(partsOf(rig, {"middle_coxa.{}", "middle_femur.{}"}), Parts({BodyPart::Coxa, BodyPart::Thigh}));
    EXPECT_EQ(partsOf(rig, {"back_stinger.{}"}), Parts({BodyPart::Other}));
    EXPECT_FALSE(isUpright(rig.model, readAnatomy(rig.model)));
}

TEST(Creatures, FiguresOnTwoLegsAreUpright)
{
    Rig rig;
    const auto hips = int32_t(rig.add("hips", -1, {0, 1, 0}));
    addLegs(rig, hips, {"thigh.{}", "shin.{}", "foot.{}"}, {0.1f, 0.9f, 0});
    EXPECT_TRUE(isUpright(rig.model, readAnatomy(rig.model)));
    addLegs(rig, int32_t(rig.add("chest", hips, {0, 1.3f, 0})), {"upper_arm.{}", "forearm.{}"}, {0.2f, 1.4f, 0.1f});
    EXPECT_TRUE(isUpright(rig.model, readAnatomy(rig.model)));
    // Duplicate bones at one place are no further legs.
    addLegs(rig, hips, {"thigh_d.{}", "shin_d.{}", "foot_d.{}"}, {0.1f, 0.9f, 0});
    EXPECT_TRUE(isUpright(rig.model, readAnatomy(rig.model)));
}

/// A creature's body with a figure's at its front: the spine reaches the last shoulders.
TEST(Creatures, ASpineReachesToTheShouldersFarthestFromTheHips)
{
    Rig rig = quadruped({"shoulder.{}", "front_thigh.{}", "front_shin.{}", "front_foot.{}"},
                        {"thigh.{}", "shin.{}", "foot.{}"});
    rig.model.bones[rig.find("neck")].name = "waist";
    rig.model.bones[rig.find("head")].name = "spine.001";
    const auto last = int32_t(rig.add("spine.002", int32_t(rig.find("spine.001")), {0, 0.9f, 0.5f}));
    for (const int side : {1, -1}) {
        const std::string end = side > 0 ? ".L" : ".R";
        rig.add("forearm" + end, int32_t(rig.add("upper_arm" + end, last, {0.2f * float(side), 1, 0.5f}, "", side)),
                {0.4f * float(side), 1, 0.5f}, "", side);
    }
    rig.add("spine.004", int32_t(rig.add("spine.003", last, {0, 1.1f, 0.5f})), {0, 1.2f, 0.5f});
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    for (const char* name : {"waist", "spine.001", "spine.002"})
        EXPECT_EQ(anatomy[rig.find(name)].part, BodyPart::Spine) << name;
    EXPECT_EQ(anatomy[rig.find("spine.003")].part, BodyPart::Neck);
    EXPECT_EQ(anatomy[rig.find("spine.004")].part, BodyPart::Head);
}

TEST(Creatures, AHandAloneHasFingers)
{
    Rig rig;
    const auto hand = int32_t(rig.add("hand", -1, {0, 0, 0}));
    for (const char* finger : {"thumb", "index", "middle", "ring"})
        rig.add(finger + std::string("_02"), int32_t(rig.add(finger + std::string("_01"), hand, {0, 0.1f, 0})),
                {0, 0.2f, 0});
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    EXPECT_EQ(anatomy[rig.find("hand")].part, BodyPart::Hand);
    EXPECT_EQ(anatomy[rig.find("thumb_02")].part, BodyPart::Finger);
    EXPECT_EQ(anatomy[rig.find("ring_01")].part, BodyPart::Finger);
}

TEST(Creatures, ArmsWithoutASideOfWhatHasNoLegsAreAMachines)
{
    const auto chain = [](const Names& names) {
        Rig rig;
        for (const std::string& name : names) rig.add(name, int32_t(rig.model.bones.size()) - 1, {0, 1, 0});
        Parts parts;
        for (const BoneAnatomy& bone : readAnatomy(rig.model)) parts.push_back(bone.part);
        return parts;
    };
    constexpr BodyPart LEVER = BodyPart::Lever;
    EXPECT_EQ(chain({"base", "boom", "dipper", "bucket"}), Parts({BodyPart::Other, LEVER, LEVER, LEVER}));
    EXPECT_EQ(chain({"base", "arm1", "arm2", "hand"}), Parts({BodyPart::Other, LEVER, LEVER, LEVER}));
    EXPECT_EQ(chain({"hips", "arm1", "arm2"})[1], BodyPart::UpperArm);
    EXPECT_EQ(chain({"base", "arm1.L", "arm2.L"})[1], BodyPart::UpperArm);
}

}  // namespace knuckle::test
