#include "tests/rig/actor_fixture.h"
#include "tests/rig/figures/box_figure.h"

namespace knuckle::test {
namespace {

Actor made(const BoxBones& bones)
{
    Actor actor = make(boxFigure(bones), 0.035f);
    expectSound(actor);
    return actor;
}

/// The dog with its feet on the root, renamed, and with all bones in reversed order if requested.
BoxBones dogWithFeetAtRoot(const std::string& front, const std::string& back, bool reversed)
{
    BoxBones bones = boxDog();
    for (BoxBone& bone : bones) {
        const bool foot = bone.name.find("Foot") != std::string::npos;
        if (!foot) continue;
        const std::string side = bone.name.substr(bone.name.size() - 2);
        bone.parent = "root";
        bone.name = (bone.name.starts_with("Front") ? front : back) + side;
    }
    if (reversed) std::ranges::reverse(bones);
    return bones;
}

/// For a dog whose feet hang on its root, with these names: each goes to the leg of its end and side.
void expectFeetOnTheirLegs(const std::string& front, const std::string& back, bool reversed)
{
    const BoxBones bones = dogWithFeetAtRoot(front, back, reversed);
    const Model model = boxFigure(bones);
    const Actor actor = made(bones);
    for (const std::string side : {".L", ".R"}) {
        EXPECT_EQ(ownerOf(model, front + side), "FrontLowLeg" + side);
        EXPECT_EQ(ownerOf(model, back + side), "BackLowLeg" + side);
        EXPECT_EQ(parentOf(actor, front + side), "FrontLowLeg" + side);
        EXPECT_EQ(parentOf(actor, back + side), "BackLowLeg" + side);
    }
}

TEST(LimbEnds, FeetAtTheRootGoWhereTheirWordsSay)
{
    const std::vector<std::pair<std::string, std::string>> names{{"FrontFoot", "BackFoot"},
                                                                 {"fore_paw", "hind_paw"},
                                                                 {"Hoof_front", "Hoof_rear"},
                                                                 {"IK_FrontPaw", "IK_BackPaw"}};
    for (const auto& [front, back] : names) {
        for (const bool reversed : {false, true}) expectFeetOnTheirLegs(front, back, reversed);
    }
}

TEST(LimbEnds, FeetThatDoNotSayWhichTheyAreGoWhereTheyStand)
{
    for (const auto& [front, back] : {std::pair("Paw1", "Paw2"), {"Flurb", "Glonk"}}) {
        expectFeetOnTheirLegs(front, back, false);
    }
}

TEST(LimbEnds, WordsWinOverWhereTheyStand)
{
    // A foot's bone begins at its control, which is at the other leg.
    BoxBones bones = dogWithFeetAtRoot("FrontFoot", "BackFoot", false);
    for (const std::string side : {".L", ".R"}) {
        boneOf(bones, "FrontFoot" + side).head.z() = -0.3f;
        boneOf(bones, "BackFoot" + side).head.z() = 0.3f;
    }
    const Actor actor = made(bones);
    EXPECT_EQ(parentOf(actor, "FrontFoot.L"), "FrontLowLeg.L");
    EXPECT_EQ(parentOf(actor, "BackFoot.R"), "BackLowLeg.R");
}

TEST(LimbEnds, NumbersSayWhichLegAFootIsOf)
{
    BoxBones bones{{"root", "", {0, 0, 0}},
                   {"Hips", "root", {0, 0.4f, 0}, {0, 0.4f, 0}, {0.2f, 0.1f, 0.5f}},
                   {"Head", "Hips", {0, 0.4f, 0.5f}, {0, 0.4f, 0.6f}, {0.1f, 0.1f, 0.1f}}};
    for (const float x : {1.0f, -1.0f}) {
        const std::string side = x > 0 ? "_L" : "_R";
        for (int k = 1; k <= 3; ++k) {
            const float z = 0.6f - 0.3f * static_cast<float>(k);
            const std::string n = std::to_string(k);
            bones.push_back(
                {"Thigh" + n + side, "Hips", {0.2f * x, 0.4f, z}, {0.35f * x, 0.45f, z}, {0.15f, 0.05f, 0.05f}});
            bones.push_back({"Shin" + n + side,
                             "Thigh" + n + side,
                             {0.5f * x, 0.45f, z},
                             {0.5f * x, 0.28f, z},
                             {0.05f, 0.18f, 0.05f}});
            // Each begins at the preceding leg.
            bones.push_back(
                {"Foot" + n + side, "root", {0.5f * x, 0.1f, z + 0.25f}, {0.5f * x, 0.05f, z}, {0.06f, 0.05f, 0.08f}});
        }
    }
    const Actor actor = made(bones);
    for (const std::string leg : {"1_L", "2_L", "3_L", "1_R", "2_R", "3_R"})
        EXPECT_EQ(parentOf(actor, "Foot" + leg), "Shin" + leg);
}

TEST(LimbEnds, HandsAtTheRootGoOnArmsAndFeetOnLegs)
{
    BoxBones bones = boxPerson();
    bones.insert(bones.begin(), {"root", "", {0, 0, 0}});
    boneOf(bones, "hips").parent = "root";
    for (const float x : {1.0f, -1.0f}) {
        const std::string side = x > 0 ? ".L" : ".R";
        boneOf(bones, "foot" + side).parent = "root";
        bones.push_back({"wrist" + side, "root", {0.7f * x, 1.35f, 0}, {0.78f * x, 1.35f, 0}, {0.08f, 0.04f, 0.05f}});
    }
    const Actor actor = made(bones);
    for (const std::string side : {".L", ".R"}) {
        EXPECT_EQ(ownerOf(boxFigure(bones), "foot" + side), "shin" + side);
        EXPECT_EQ(ownerOf(boxFigure(bones), "wrist" + side), "forearm" + side);
        EXPECT_EQ(parentOf(actor, "foot" + side), "shin" + side);
        EXPECT_EQ(parentOf(actor, "wrist" + side), "forearm" + side);
    }
}

TEST(LimbEnds, CornersOfAQuadrupedAreSidesToo)
{
    for (const auto& [front, back, leg] : {std::tuple("F?", "B?", "_leg"),
                                           {"?F", "?B", "_leg"},
                                           {"F?", "H?", "_leg"},
                                           {"F?", "R?", "_leg"},
                                           {"F?", "B?", ""}}) {
        const std::string lowerLeg = std::string("_lower") + leg, upperLeg = std::string("_upper") + leg;
        BoxBones bones = boxDog();
        for (BoxBone& bone : bones) {
            for (std::string* name : {&bone.name, &bone.parent}) {
                if (!name->ends_with(".L") && !name->ends_with(".R")) continue;
                std::string corner = name->starts_with("Front") ? front : back;
                corner[corner.find('?')] = name->back();
                const bool lower = name->find("LowLeg") != name->npos, foot = name->find("Foot") != name->npos;
                *name = corner + (lower ? lowerLeg : foot ? "_paw" : upperLeg);
            }
            if (bone.name.ends_with("_paw")) bone.parent = "root";
        }
        const Model model = boxFigure(bones);
        const Actor actor = made(bones);
        for (const ActorBody& body : actor.bodies) {
            if (!body.name.ends_with("_paw")) continue;
            const std::string corner = body.name.substr(0, 2);
            EXPECT_EQ(ownerOf(model, body.name), corner + lowerLeg);
            EXPECT_EQ(parentOf(actor, body.name), corner + lowerLeg);
            EXPECT_EQ(jointOf(actor, corner + lowerLeg).type, JointType::Hinge);
        }
        EXPECT_EQ(std::ranges::count_if(actor.bodies, [](const auto& body) { return body.name.ends_with("_paw"); }), 4);
    }
}

struct Chain {
    std::vector<std::string> names;
    std::vector<BodyPart> parts;
};

/// A figure with other bones in its legs; x of the left ones is positive.
Model withLegs(const std::vector<std::string>& names)
{
    BoxBones bones = boxPerson();
    std::erase_if(bones, [](const BoxBone& bone) {
        return bone.name.find("thigh") != std::string::npos || bone.name.find("shin") != std::string::npos ||
               bone.name.find("foot") != std::string::npos;
    });
    for (const float x : {1.0f, -1.0f}) {
        std::string parent = "hips";
        const auto count = static_cast<float>(names.size());
        for (size_t i = 0; i < names.size(); ++i) {
            const float top = 0.88f * (1.0f - static_cast<float>(i) / count), half = 0.44f / count;
            const std::string name = names[i] + (x > 0 ? ".L" : ".R");
            bones.push_back({name, parent, {0.09f * x, top, 0}, {0.09f * x, top - half, 0}, {0.06f, half, 0.06f}});
            parent = name;
        }
    }
    return boxFigure(bones);
}

TEST(LimbEnds, PartsOfALegComeInTheirOrderWhateverTheirWords)
{
    using enum BodyPart;
    const std::vector<Chain> chains{
        {{"Leg_Upper", "Leg_Lower", "Leg_Ankle", "Leg_Foot", "Leg_Tip"}, {Thigh, Shin, Foot, Toe, Toe}},
        {{"thigh", "shin", "foot", "thigh_tip"}, {Thigh, Shin, Foot, Toe}},
        {{"thigh", "shin", "foot", "toe", "shin_tip"}, {Thigh, Shin, Foot, Toe, Toe}},
        {{"Leg", "LegLow", "Paw", "LegEndTip"}, {Thigh, Shin, Foot, Toe}},
        {{"foot_top", "shin", "foot"}, {Thigh, Shin, Foot}},
        {{"knee_upper", "calf", "ankle"}, {Thigh, Shin, Foot}},
    };
    for (const Chain& chain : chains) {
        const Model model = withLegs(chain.names);
        const std::vector<BoneAnatomy> anatomy = readAnatomy(model);
        for (size_t i = 0; i < chain.names.size(); ++i)
            for (const char* side : {".L", ".R"})
                EXPECT_EQ(int(anatomy[indexOf(model, chain.names[i] + side)].part), int(chain.parts[i]))
                    << chain.names[i] << " below " << (i > 0 ? chain.names[i - 1] : "hips");
    }
}

TEST(LimbEnds, ADogsLegsThatAllSayLegAreFrontAndHindLegs)
{
    BoxBones bones = boxDog();
    for (BoxBone& bone : bones) {
        for (std::string* name : {&bone.name, &bone.parent}) {
            if (const size_t at = name->find("LowLeg"); at != std::string::npos) name->replace(at, 6, "_Leg_Lower");
            else if (const size_t foot = name->find("Foot"); foot != std::string::npos)
                name->replace(foot, 4, "_Leg_Foot");
        }
    }
    for (const std::string leg : {"Front_Leg_Foot.L", "Front_Leg_Foot.R", "Back_Leg_Foot.L", "Back_Leg_Foot.R"}) {
        const Vector3f head = boneOf(bones, leg).head + Vector3f(0, -0.03f, 0.12f);
        std::string tip = leg;
        bones.push_back(
            {tip.replace(tip.find("Foot"), 4, "Tip"), leg, head, head + Vector3f(0, 0, 0.05f), {0.045f, 0.03f, 0.05f}});
    }
    const Model model = boxFigure(bones);
    const std::vector<BoneAnatomy> anatomy = readAnatomy(model);
    EXPECT_EQ(anatomy[indexOf(model, "FrontLeg.L")].part, BodyPart::UpperArm);
    EXPECT_EQ(anatomy[indexOf(model, "BackLeg.L")].part, BodyPart::Thigh);
    EXPECT_EQ(anatomy[indexOf(model, "Front_Leg_Tip.L")].part, BodyPart::Toe);
    EXPECT_EQ(anatomy[indexOf(model, "Back_Leg_Tip.R")].part, BodyPart::Toe);
}

}  // namespace
}  // namespace knuckle::test
