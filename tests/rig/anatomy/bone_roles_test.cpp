#include <gtest/gtest.h>

#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

Rig figure(const std::string& prefix)
{
    const auto with = [&](std::string chain) {
        for (size_t at = chain.find('$'); at != std::string::npos; at = chain.find('$')) chain.replace(at, 1, prefix);
        return chain;
    };
    return makeRig({"",
                    "L",
                    "R",
                    {with("$spine=hips > $spine.001=spine > $spine.002=spine > $spine.003=neck > $spine.004=head"),
                     with("$spine.002 > $shoulder.{}=clavicle > $upper_arm.{}=upperArm > $forearm.{}=forearm"),
                     with("$spine > $thigh.{}=thigh > $shin.{}=shin > $foot.{}=foot")}});
}

/// Each bone as a control, and at the same place one with skin, on the parent that `parent` gives for the control.
Rig doubled(int32_t (*parent)(const Rig& controls, uint32_t control))
{
    Rig rig;
    rig.add("root", -1, {0, 0, 0}, "control");
    const Rig controls = figure("ORG-");
    const auto count = uint32_t(controls.model.bones.size());
    const auto head = [&](uint32_t b) { return Eigen::Vector3f(controls.model.bones[b].restPose.block<3, 1>(0, 3)); };
    for (uint32_t b = 0; b < count; ++b)
        rig.add(controls.model.bones[b].name, controls.model.bones[b].parent + 1, head(b), "control",
                controls.sides[b]);
    for (uint32_t b = 0; b < count; ++b)
        rig.add("DEF-" + controls.model.bones[b].name.substr(4), parent(controls, b), head(b), controls.expected[b],
                controls.sides[b]);
    return rig;
}

/// Every bone with skin hangs on the one named like its control's parent.
void expectTree(const Rig& rig)
{
    const Rig figure_ = figure("DEF-");
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    for (const Bone& bone : figure_.model.bones) {
        const int32_t parent = anatomy[rig.find(bone.name)].parent;
        const std::string on = parent < 0 ? "" : rig.model.bones[parent].name;
        EXPECT_EQ(on, bone.parent < 0 ? "" : figure_.model.bones[bone.parent].name) << bone.name;
    }
}

}  // namespace

TEST(BoneRoles, BonesOnControlsHangAsTheseDo)
{
    expectTree(doubled([](const Rig&, uint32_t control) { return int32_t(control) + 1; }));
}

TEST(BoneRoles, ChainsThatBeginOnAControlHangOnWhatMovesAsItsParent)
{
    expectTree(doubled([](const Rig& controls, uint32_t control) {
        const std::string& name = controls.model.bones[control].name;
        const bool first = name == "ORG-spine" || name.find("shoulder") != name.npos ||
                           name.find("thigh") != name.npos || name.find("upper_arm") != name.npos;
        const auto count = int32_t(controls.model.bones.size());
        return first ? int32_t(control) + 1 : controls.model.bones[control].parent + 1 + count;
    }));
}

TEST(BoneRoles, BonesThatAllHangOnTheRootMakeATree)
{
    expectTree(doubled([](const Rig&, uint32_t) { return 0; }));
}

TEST(BoneRoles, WhatLiesBetweenHipsAndNeckIsSpine)
{
    const Rig rig = makeRig({"",
                             "L",
                             "R",
                             {"hips=hips > stomach=spine > thing=spine > neck=neck > head=head",
                              "hips > thigh.{}=thigh > shin.{}=shin > foot.{}=foot"}});
    const std::vector<BoneAnatomy> anatomy = readAnatomy(rig.model);
    for (const char* name : {"stomach", "thing"}) EXPECT_EQ(anatomy[rig.find(name)].part, BodyPart::Spine) << name;
}

}  // namespace knuckle::test
