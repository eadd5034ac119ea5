#include "tests/rig/actor_fixture.h"
#include "tests/rig/figures/box_figure.h"

namespace knuckle::test {
namespace {

/// The figure with some of its bones hung on others, in the order of the list.
BoxBones rehung(BoxBones bones, const std::vector<std::pair<std::string, std::string>>& parents)
{
    for (const auto& [name, parent] : parents) boneOf(bones, name).parent = parent;
    return bones;
}

/// The figure without the box of a bone.
BoxBones emptied(BoxBones bones, const std::string& name)
{
    boneOf(bones, name).half.setZero();
    return bones;
}

Actor made(const BoxBones& bones)
{
    Actor actor = make(boxFigure(bones), 0.04f);
    expectSound(actor);
    return actor;
}

/// Expects both sides on one body of the trunk.
void expectOn(const Actor& actor, const std::string& limb, const std::string& trunk)
{
    EXPECT_EQ(parentOf(actor, limb + ".L"), trunk) << limb;
    EXPECT_EQ(parentOf(actor, limb + ".R"), trunk) << limb;
}

/// The same, and that their bones are known to belong there.
void expectOf(const BoxBones& bones, const std::string& limb, const std::string& trunk)
{
    const Model model = boxFigure(bones);
    EXPECT_EQ(ownerOf(model, limb + ".L"), trunk) << limb;
    EXPECT_EQ(ownerOf(model, limb + ".R"), trunk) << limb;
    expectOn(made(bones), limb, trunk);
}

TEST(AdriftLimbs, OfHipsWithoutSkinHangOnTheSpineAboveThem)
{
    const Actor actor = made(emptied(boxPerson(), "hips"));
    expectOn(actor, "thigh", "spine");
    expectOn(actor, "upper_arm", "spine");
}

TEST(AdriftLimbs, OfASpineWithoutSkinHangOnTheHipsBelowIt)
{
    const Actor actor = made(emptied(boxPerson(), "spine"));
    expectOn(actor, "upper_arm", "hips");
    EXPECT_EQ(parentOf(actor, "head"), "hips");
    // As their bones do: none of it is a guess.
    for (const std::string& note : actor.notes) EXPECT_EQ(note.find("is joined to"), note.npos) << note;
}

TEST(AdriftLimbs, OnControlsHangOnTheTrunkWhateverStandsFirst)
{
    for (const bool limbsFirst : {false, true}) {
        BoxBones bones = rehung(boxPerson(), {{"hips", "root"}, {"spine", "torso"}, {"head", "torso"}});
        bones.insert(bones.begin(), {{"root", "", {0, 0, 0}}, {"torso", "root", {0, 1, 0}}});
        for (const char* side : {".L", ".R"}) {
            const std::string s = side;
            bones.push_back({"ORG-pelvis" + s, "root", {0, 0.95f, 0}});
            bones = rehung(bones, {{"thigh" + s, "ORG-pelvis" + s}, {"upper_arm" + s, "torso"}});
        }
        if (limbsFirst) std::ranges::reverse(bones);
        expectOf(bones, "thigh", "hips");
        expectOf(bones, "upper_arm", "spine");
        EXPECT_EQ(parentOf(made(bones), "spine"), "hips");
    }
}

TEST(AdriftLimbs, WithoutAnyNameOfTheTrunkNeverHangOnTheOtherSide)
{
    BoxBones bones = rehung(boxPerson(), {{"hips", "root"}, {"spine", "root"}, {"head", "root"}});
    bones.insert(bones.begin(), {"root", "", {0, 0, 0}});
    for (BoxBone& bone : bones) {
        if (bone.parent == "hips" || bone.parent == "spine") bone.parent = "root";
        for (std::string* name : {&bone.name, &bone.parent})
            if (*name == "hips" || *name == "spine") *name = *name == "hips" ? "lump" : "lump2";
    }
    // With the trunk's bodies, and with nothing but a head there.
    for (const BoxBones& figure : {bones, emptied(emptied(bones, "lump"), "lump2")}) {
        const Actor actor = made(figure);
        for (const ActorJoint& joint : actor.joints) {
            const std::string &child = actor.bodies[joint.child].name, &parent = actor.bodies[joint.parent].name;
            EXPECT_FALSE(child.ends_with(".L") && parent.ends_with(".R")) << child << " on " << parent;
            EXPECT_FALSE(child.ends_with(".R") && parent.ends_with(".L")) << child << " on " << parent;
        }
    }
}

TEST(AdriftLimbs, OfASpiderWithoutABodyHangOnTheNearestSegmentAlike)
{
    for (const bool legsFirst : {false, true}) {
        BoxBones bones{{"Root", "", {0, 0, 0}}, {"Body", "Root", {0, 0.5f, 0}}}, legs;
        const BoxBones trunk{{"Abdomen", "Body", {0, 0.55f, -0.2f}, {0, 0.6f, -0.55f}, {0.3f, 0.25f, 0.35f}},
                             {"Thorax", "Body", {0, 0.5f, -0.1f}, {0, 0.5f, 0.05f}, {0.18f, 0.1f, 0.2f}}};
        for (const float x : {1.0f, -1.0f}) {
            const std::string side = x > 0 ? ".L" : ".R";
            for (const float z : {0.2f, 0.07f, -0.07f}) {
                const std::string leg = z > 0.1f ? "FrontLeg" : z > 0 ? "MiddleLeg" : "BackLeg";
                legs.push_back({leg + side, "Body", {0.18f * x, 0.5f, z}, {0.3f * x, 0.6f, z}, {0.12f, 0.1f, 0.04f}});
                legs.push_back(
                    {leg + "Tip" + side, leg + side, {0.42f * x, 0.6f, z}, {0.45f * x, 0.3f, z}, {0.04f, 0.3f, 0.04f}});
            }
        }
        for (const BoxBones& part : legsFirst ? std::vector{legs, trunk} : std::vector{trunk, legs})
            bones.insert(bones.end(), part.begin(), part.end());
        for (const char* leg : {"FrontLeg", "MiddleLeg", "BackLeg"}) expectOf(bones, leg, "Thorax");
        EXPECT_EQ(parentOf(made(bones), "Body"), "no body");
    }
}

}  // namespace
}  // namespace knuckle::test
