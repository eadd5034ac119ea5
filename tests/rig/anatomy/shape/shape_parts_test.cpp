#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "sim/rig/anatomy/bone_tree.h"
#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

using Eigen::Vector3f;

/// A rig whose bones are called node0, node1, ... and turned about y.
struct Nameless : Rig {
    float yaw = 0.0f;
    bool sidesNamed = false;

    uint32_t node(int32_t parent, const Vector3f& head, const std::string& is)
    {
        std::string name = "node" + std::to_string(model.bones.size());
        if (sidesNamed && head.x() != 0.0f) name += head.x() > 0.0f ? ".L" : ".R";
        return add(name, parent, Eigen::AngleAxisf(yaw, Vector3f::UnitY()) * head, is, (head.x() > 0) - (head.x() < 0));
    }
    /// Adds a chain on both sides, by the heads of the left one.
    void limbs(uint32_t base, const std::vector<Vector3f>& heads, const std::vector<std::string>& parts)
    {
        for (const float side : {1.0f, -1.0f}) {
            auto parent = static_cast<int32_t>(base);
            for (size_t i = 0; i < heads.size(); ++i)
                parent = static_cast<int32_t>(
                    node(parent, {side * heads[i].x(), heads[i].y(), heads[i].z()}, parts[i]));
        }
    }
    uint32_t chain(int32_t parent, const std::vector<Vector3f>& heads, const std::vector<std::string>& parts)
    {
        for (size_t i = 0; i < heads.size(); ++i) parent = static_cast<int32_t>(node(parent, heads[i], parts[i]));
        return static_cast<uint32_t>(parent);
    }
};

const std::vector<Vector3f> LEG = {
    {0.1f, 0.9f, 0}, {0.11f, 0.5f, 0.02f}, {0.12f, 0.09f, -0.02f}, {0.12f, 0.02f, 0.12f}};
const std::vector<std::string> LEG_PARTS = {"thigh", "shin", "foot", "toe"};

Nameless humanoid(float yaw, bool sidesNamed, bool clavicles)
{
    Nameless rig;
    rig.yaw = yaw;
    rig.sidesNamed = sidesNamed;
    const uint32_t hips = rig.node(-1, {0, 0.95f, 0}, "hips");
    rig.limbs(hips, LEG, LEG_PARTS);
    const uint32_t chest = rig.chain(int32_t(hips), {{0, 1.05f, 0}, {0, 1.25f, 0}}, {"spine", "spine"});
    rig.chain(int32_t(chest), {{0, 1.45f, 0}, {0, 1.55f, 0.02f}}, {"neck", "head"});
    std::vector<Vector3f> arm = {{0.05f, 1.4f, 0}, {0.18f, 1.4f, 0}, {0.45f, 1.38f, 0}, {0.7f, 1.38f, 0}};
    std::vector<std::string> parts = {"clavicle", "upperArm", "forearm", "hand"};
    if (!clavicles) arm.erase(arm.begin()), parts.erase(parts.begin());
    rig.limbs(chest, arm, parts);
    return rig;
}

/// A creature that faces +z, with that many pairs of legs, the first at its tail.
Nameless creature(int pairs)
{
    Nameless rig;
    uint32_t trunk = rig.node(-1, {0, 0.6f, -0.5f}, "hips");
    rig.chain(int32_t(trunk), {{0, 0.6f, -0.65f}, {0, 0.55f, -0.8f}, {0, 0.5f, -0.95f}}, {"tail", "tail", "tail"});
    for (int pair = 0; pair < pairs; ++pair) {
        const float z = -0.5f + 0.4f * static_cast<float>(pair);
        if (pair > 0) trunk = rig.chain(int32_t(trunk), {{0, 0.62f, z - 0.2f}, {0, 0.62f, z}}, {"spine", "spine"});
        const bool fore = pairs == 2 && pair == 1;
        const std::vector<std::string> leg = {"thigh", "shin", "foot"}, arm = {"upperArm", "forearm", "hand"};
        rig.limbs(trunk, {{0.12f, 0.55f, z}, {0.13f, 0.3f, z + 0.05f}, {0.13f, 0.05f, z}}, fore ? arm : leg);
    }
    rig.chain(int32_t(trunk), {{0, 0.7f, 0.6f}, {0, 0.8f, 0.7f}}, {"neck", "head"});
    return rig;
}

const std::map<std::string, BodyPart> PARTS = {
    {"hips", BodyPart::Hips},       {"spine", BodyPart::Spine},       {"neck", BodyPart::Neck},
    {"head", BodyPart::Head},       {"hand", BodyPart::Hand},         {"clavicle", BodyPart::Clavicle},
    {"thigh", BodyPart::Thigh},     {"shin", BodyPart::Shin},         {"foot", BodyPart::Foot},
    {"toe", BodyPart::Toe},         {"tail", BodyPart::Tail},         {"", BodyPart::Other},
    {"forearm", BodyPart::Forearm}, {"upperArm", BodyPart::UpperArm}, {"wing", BodyPart::Wing},
    {"finger", BodyPart::Finger},   {"coxa", BodyPart::Coxa}};

/// @param first, end of the bones to compare.
void expectRead(const Rig& rig, uint32_t first = 0, uint32_t end = NO_INDEX)
{
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    for (uint32_t b = first; b < std::min<size_t>(anatomy.size(), end); ++b) {
        EXPECT_EQ(anatomy[b].part, PARTS.at(rig.expected[b])) << b << ", a " << rig.expected[b];
        EXPECT_EQ(anatomy[b].source, AnatomySource::Shape) << b;
        EXPECT_EQ(anatomy[b].role, BoneRole::Limb) << b;
        EXPECT_EQ(anatomy[b].side, rig.sides[b]) << b << ", a " << rig.expected[b];
    }
}

}  // namespace

TEST(ShapeParts, AFigureWithoutNamesHasLegsArmsAndAHead)
{
    for (const float yaw : {0.0f, 0.6f, 1.6f, 3.1f})
        for (const bool sidesNamed : {false, true})
            for (const bool clavicles : {false, true}) expectRead(humanoid(yaw, sidesNamed, clavicles));
}

TEST(ShapeParts, WhatForksAtTheHandsIsFingers)
{
    for (const bool clavicles : {false, true}) {
        Nameless rig = humanoid(0, false, clavicles);
        for (uint32_t b = 0, count = uint32_t(rig.model.bones.size()); b < count; ++b) {
            if (rig.expected[b] != "hand") continue;
            const Vector3f hand = rig.model.bones[b].restPose.block<3, 1>(0, 3), out(0.1f * hand.x(), 0, 0);
            for (const float z : {-0.03f, 0.0f, 0.03f})
                rig.chain(int32_t(b), {hand + out + Vector3f(0, 0, z), hand + 1.5f * out + Vector3f(0, 0, z)},
                          {"finger", "finger"});
        }
        expectRead(rig);
    }
}

TEST(ShapeParts, ACreatureHasMoreLegsAndATail)
{
    for (const int pairs : {2, 3, 4}) expectRead(creature(pairs));
}

/// Eight legs that begin with a short piece, rise to the knee and have their tips on the ground, rather than their last
/// heads.
TEST(ShapeParts, LegsOfASpiderEndInTheirShins)
{
    for (const bool feet : {false, true}) {
        Nameless rig;
        const uint32_t trunk = rig.node(-1, {0, 0.3f, 0}, "hips");
        for (const float z : {-0.3f, -0.1f, 0.1f, 0.3f}) {
            std::vector<Vector3f> leg = {{0.1f, 0.3f, z}, {0.16f, 0.3f, z}, {0.4f, 0.5f, z}};
            std::vector<std::string> parts = {"coxa", "thigh", "shin"};
            if (feet) leg.emplace_back(0.58f, 0.04f, z), parts.emplace_back("foot");
            rig.limbs(trunk, leg, parts);
        }
        rig.chain(int32_t(trunk), {{0, 0.35f, 0.45f}, {0, 0.35f, 0.55f}}, {"neck", "head"});
        for (uint32_t v = 0; v < rig.model.vertices.size(); ++v)
            if (rig.expected[v] == "shin" && !feet) rig.model.vertices[v] += Vector3f(0, -0.5f, 0);
        expectRead(rig);
    }
}

TEST(ShapeParts, ALongFrontLegBeginsWithItsBlade)
{
    Nameless rig;
    const uint32_t hips = rig.node(-1, {0, 0.5f, -0.3f}, "hips");
    rig.limbs(hips, {{0.1f, 0.48f, -0.3f}, {0.1f, 0.3f, -0.2f}, {0.1f, 0.2f, -0.4f}, {0.1f, 0.05f, -0.35f}},
              {"thigh", "shin", "shin", "foot"});
    const uint32_t chest = rig.chain(int32_t(hips), {{0, 0.52f, -0.1f}, {0, 0.52f, 0.1f}}, {"spine", "spine"});
    rig.limbs(chest, {{0.1f, 0.55f, 0.2f}, {0.1f, 0.42f, 0.28f}, {0.1f, 0.3f, 0.2f}, {0.1f, 0.06f, 0.22f}},
              {"clavicle", "upperArm", "forearm", "hand"});
    rig.chain(int32_t(chest), {{0, 0.6f, 0.35f}, {0, 0.7f, 0.45f}}, {"neck", "head"});
    expectRead(rig);
}

TEST(ShapeParts, APairThatLeavesACreaturesTrunkAboveTheGroundIsWings)
{
    Nameless rig = creature(2);
    const auto shoulders = uint32_t(std::ranges::find(rig.expected, "neck") - rig.expected.begin());
    rig.limbs(uint32_t(rig.model.bones[shoulders].parent), {{0.1f, 0.7f, -0.1f}, {0.5f, 0.9f, -0.1f}, {0.9f, 0.8f, 0}},
              {"wing", "wing", "wing"});
    expectRead(rig);
}

TEST(ShapeParts, AFigureMayWalkSitAndCarrySomething)
{
    const auto moveBelow = [](Nameless& rig, const std::string& top, float side, const Vector3f& pivot, float angle) {
        const BoneTree tree(rig.model);
        for (uint32_t b = 0; b < tree.size(); ++b) {
            const Vector3f head = tree.heads[b];
            const int32_t on = rig.expected[b] == top
                                   ? int32_t(b)
                                   : tree.above(b, [&](uint32_t other) { return rig.expected[other] == top; });
            if (on < 0 || head.x() * side < 0.0f) continue;
            rig.model.bones[b].restPose.block<3, 1>(0, 3) = pivot + Eigen::AngleAxisf(angle, Vector3f::UnitX()) *
                                                                        Vector3f(head - pivot);
            rig.model.vertices[b] = rig.model.bones[b].restPose.block<3, 1>(0, 3);
        }
    };
    Nameless walks = humanoid(0, false, true);
    moveBelow(walks, "thigh", 1, {0, 0.9f, 0}, -0.5f);
    moveBelow(walks, "thigh", -1, {0, 0.9f, 0}, 0.4f);
    expectRead(walks);
    // The scene's root, which has no skin, stays on the ground.
    Nameless sits;
    sits.node(-1, {0, 0, 0}, "control");
    sits.model.skin[0].weights[0] = 0.0f;
    const Nameless stands = humanoid(0, false, true);
    for (uint32_t b = 0; b < stands.model.bones.size(); ++b)
        sits.node(stands.model.bones[b].parent + 1, stands.model.bones[b].restPose.block<3, 1>(0, 3),
                  stands.expected[b]);
    for (const float side : {1.0f, -1.0f}) {
        moveBelow(sits, "thigh", side, {0, 0.9f, 0}, -1.57f);
        moveBelow(sits, "shin", side, {0, 0.9f, 0.4f}, 1.57f);
    }
    sits.expected[0] = "";
    expectRead(sits, 1);
    Nameless carries = humanoid(0, false, true);
    auto parent = int32_t(std::ranges::find(carries.expected, "hand") - carries.expected.begin());
    for (int i = 0; i < 8; ++i) {
        parent = int32_t(carries.add("sword_" + std::to_string(i), parent, {0.9f + 0.2f * float(i), 1.4f, 0}));
        carries.sides.back() = 1;
    }
    expectRead(carries, 0, uint32_t(parent) - 7);
    // ... also if no name says what it is.
    for (uint32_t b = 0; b < carries.model.bones.size(); ++b) carries.model.bones[b].name = "x" + std::to_string(b);
    expectRead(carries, 0, uint32_t(parent) - 7);
}

TEST(ShapeParts, OfSeveralPairsOnAFiguresTrunkThoseAsLongAsArmsAreArms)
{
    const std::vector<std::string> arm = {"clavicle", "upperArm", "forearm", "hand"};
    Nameless rig = humanoid(0, false, true);
    const auto chest = uint32_t(rig.model.bones[std::ranges::find(rig.expected, "neck") - rig.expected.begin()].parent);
    rig.limbs(chest, {{0.05f, 1.4f, -0.1f}, {0.5f, 1.7f, -0.3f}, {1.2f, 1.6f, -0.4f}}, {"wing", "wing", "wing"});
    expectRead(rig);
    // On the spine below the chest, whose own arms are longer chains.
    Nameless four = humanoid(0, false, true);
    four.limbs(uint32_t(four.model.bones[chest].parent),
               {{0.05f, 1.2f, 0}, {0.18f, 1.2f, 0}, {0.45f, 1.18f, 0}, {0.7f, 1.18f, 0}}, arm);
    expectRead(four);
}

TEST(ShapeParts, APonytailIsNoHead)
{
    Nameless rig = humanoid(0, false, true);
    const auto head = uint32_t(std::ranges::find(rig.expected, "head") - rig.expected.begin());
    rig.chain(int32_t(head), {{0, 1.65f, -0.1f}, {0, 1.5f, -0.15f}, {0, 1.35f, -0.2f}}, {"", "", ""});
    for (uint32_t v = 0; v < rig.model.vertices.size(); ++v) rig.model.vertices[v].y() += v == head ? 0.2f : 0.04f;
    expectRead(rig, 0, head + 1);
    EXPECT_EQ(readAnatomy(rig.model).back().role, BoneRole::Attached);
}

TEST(ShapeParts, WhatHasNoLegsHasNoParts)
{
    Rig arm;
    for (int i = 0; i < 5; ++i) arm.add("node" + std::to_string(i), i - 1, {0.2f * float(i), 0.1f * float(i * i), 0});
    for (const BoneAnatomy& bone : readAnatomy(arm.model)) {
        EXPECT_EQ(bone.part, BodyPart::Other);
        EXPECT_EQ(bone.source, AnatomySource::None);
    }
}

TEST(ShapeParts, NamesOfLimbsWinOverShape)
{
    Nameless rig = humanoid(0, false, true);
    rig.model.bones[1].name = "forearm.L";
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    EXPECT_EQ(anatomy[1].source, AnatomySource::Name);
    EXPECT_EQ(anatomy[1].part, BodyPart::Forearm);
    EXPECT_EQ(std::ranges::count(anatomy, AnatomySource::Shape, &BoneAnatomy::source), 0);
}

}  // namespace knuckle::test
