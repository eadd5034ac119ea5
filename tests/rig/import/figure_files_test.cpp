#include <gtest/gtest.h>

#include <algorithm>

#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
#include "tests/rig/figures/box_figure.h"
#include "tests/rig/import/chain.h"
#include "tests/rig/import/edited_glb.h"
#include "tests/temp_folder.h"

namespace knuckle::test {
namespace {

using Json = nlohmann::json;

/// Figures as files contain them.
class FigureFiles : public testing::Test {
protected:
    Model import(EditedGlb& glb, const std::string& skeleton = "") const
    {
        ImportOptions options;
        options.pick.skeleton = skeleton;
        return importModel(folder_.write("figure.glb", glb.bytes()), options);
    }
    static Json& node(EditedGlb& glb, const std::string& name)
    {
        return *std::ranges::find_if(glb.root["nodes"], [&](const Json& n) { return n.value("name", "") == name; });
    }
    /// Turns a node about an axis by an angle [rad].
    static void turn(EditedGlb& glb, const std::string& name, const Vector3f& axis, float angle)
    {
        const Quaternionf q(Eigen::AngleAxisf(angle, axis));
        node(glb, name)["rotation"] = {q.x(), q.y(), q.z(), q.w()};
    }
    /// Puts all of a scene below a node.
    static void hold(EditedGlb& glb, Json holder)
    {
        holder["children"] = glb.root["scenes"][0]["nodes"];
        glb.root["nodes"].push_back(holder);
        glb.root["scenes"][0]["nodes"] = {glb.root["nodes"].size() - 1};
    }
    static bool hasNote(const Model& model, const std::string& text)
    {
        return std::ranges::any_of(model.notes, [&](const std::string& note) { return note.find(text) != note.npos; });
    }
    /// A figure in the middle of a run.
    static EditedGlb running()
    {
        EditedGlb glb(toGlb(boxFigure(boxPerson())));
        turn(glb, "hips", Vector3f::UnitY(), 0.35f);
        turn(glb, "thigh.L", Vector3f::UnitX(), -1.0f);
        turn(glb, "shin.L", Vector3f::UnitX(), 1.2f);
        turn(glb, "thigh.R", Vector3f::UnitX(), 0.5f);
        turn(glb, "upper_arm.L", Vector3f::UnitZ(), -1.2f);
        return glb;
    }
    static void expectSame(const Model& model, const Model& expected)
    {
        ASSERT_EQ(model.vertices.size(), expected.vertices.size());
        for (size_t v = 0; v < model.vertices.size(); ++v)
            ASSERT_LT((model.vertices[v] - expected.vertices[v]).norm(), 1e-4f) << v;
        for (size_t b = 0; b < model.bones.size(); ++b)
            EXPECT_LT((model.bones[b].restPose - expected.bones[b].restPose).norm(), 1e-4f) << model.bones[b].name;
    }

    TempFolder folder_;
};

TEST_F(FigureFiles, NodesThatStandInAClipsFrameAreNoRestPose)
{
    EditedGlb plain(toGlb(boxFigure(boxPerson()))), posed = running();
    const Model expected = import(plain), model = import(posed);
    EXPECT_FALSE(hasNote(expected, "another pose"));
    EXPECT_TRUE(hasNote(model, "Nodes of 13 bones stand in another pose"));
    expectSame(model, expected);
}

TEST_F(FigureFiles, SoDoTheyBelowAnArmatureThatIsTurnedAndScaled)
{
    const Json armature{
        {"name", "Armature"}, {"rotation", {-0.70710678f, 0, 0, 0.70710678f}}, {"scale", {0.01f, 0.01f, 0.01f}}};
    // In Blender's form: centimetres, z up.
    const auto inCentimetres = [&](EditedGlb glb) {
        hold(glb, {{"name", "up"}, {"rotation", {0.70710678f, 0, 0, 0.70710678f}}, {"scale", {100, 100, 100}}});
        hold(glb, armature);
        return glb;
    };
    EditedGlb plain = inCentimetres(EditedGlb(toGlb(boxFigure(boxPerson())))), posed = inCentimetres(running());
    const Model expected = import(plain), model = import(posed);
    EXPECT_TRUE(hasNote(model, "another pose"));
    expectSame(model, expected);
}

TEST_F(FigureFiles, BindMatricesThatAreNoPoseSayNothing)
{
    for (const bool absent : {true, false}) {
        EditedGlb glb = running();
        Json& skin = glb.root["skins"][0];
        if (absent) skin.erase("inverseBindMatrices");
        else {
            std::vector<float> identity;
            for (size_t b = 0; b < skin["joints"].size(); ++b)
                for (int i = 0; i < 16; ++i) identity.push_back(i % 5 == 0 ? 1.0f : 0.0f);
            skin["inverseBindMatrices"] = glb.add(identity, 16, 5126, "MAT4");
        }
        const Model model = import(glb);
        EXPECT_FALSE(hasNote(model, "another pose"));
        // The thigh is at its node's place.
        const auto shin = boneHead(model, indexOf(model, "shin.L")), thigh = boneHead(model, indexOf(model, "thigh.L"));
        EXPECT_GT((shin - thigh).head<1>().norm() + std::abs((shin - thigh).z()), 0.2f);
    }
}

TEST_F(FigureFiles, RigidPartsOnNamedBonesAreAFigureWithoutAClip)
{
    // Skinned by code, then without the skin: a mesh on each bone.
    for (const bool meshesOnBones : {false, true}) {
        const BoxBones bones = boxPerson();
        EditedGlb glb(toGlb(boxFigure(bones)));
        glb.root.erase("skins");
        for (Json& n : glb.root["nodes"]) n.erase("skin"), n.erase("mesh");
        for (const BoxBone& bone : bones) {
            const size_t mesh = glb.addMesh(bone.name + "_mesh", boxMesh(bone.centre - bone.head, bone.half));
            if (meshesOnBones) {
                node(glb, bone.name)["mesh"] = glb.root["nodes"][mesh]["mesh"];
                glb.root["nodes"][mesh].erase("mesh");
            } else node(glb, bone.name)["children"].push_back(mesh);
        }
        const Model model = import(glb);
        ASSERT_EQ(model.bones.size(), bones.size());
        EXPECT_TRUE(hasNote(model, "of what is called after parts of a body 13 bones were made"));
        const Actor actor = makeActor(model, {.name = {}, .voxels = {.diameter = 0.04f}, .articulation = {}});
        EXPECT_EQ(parentOf(actor, "shin.L"), "thigh.L");
        EXPECT_EQ(jointOf(actor, "forearm.R").type, JointType::Hinge);
    }
}

TEST_F(FigureFiles, RigidPartsOfAChairAreNone)
{
    EditedGlb glb(toGlb(chain("unused", 1, 0)));
    glb.root.erase("skins");
    for (Json& n : glb.root["nodes"]) n.erase("skin"), n.erase("mesh");
    for (const char* name : {"Seat", "Back", "Leg.L", "Leg.R", "Arm.L", "Arm.R"})
        glb.root["scenes"][0]["nodes"].push_back(glb.addMesh(name, boxMesh({0, 0.5f, 0}, {0.2f, 0.2f, 0.2f})));
    EXPECT_TRUE(import(glb).bones.empty());
}

TEST_F(FigureFiles, WhatStoodBesideAnExportedFigureIsNotOfIt)
{
    Model figure = boxFigure(boxPerson());
    for (size_t b = 0; b < figure.bones.size(); ++b) figure.bones[b].name = "nodes[" + std::to_string(2 * b) + "]";
    std::vector<Model> models{figure};
    for (const float x : {0.1f, 0.8f, -0.8f}) models.push_back(chain("body", 1, x));
    GlbOptions options;
    options.apart = true;
    EditedGlb alone(toGlb(figure)), beside(toGlb(models, options));
    const Model expected = import(alone), model = import(beside);
    ASSERT_EQ(model.bones.size(), expected.bones.size());
    expectSame(model, expected);
    EXPECT_TRUE(hasNote(model, "Of 4 skeletons only nodes[0] was taken."));
    EXPECT_EQ(import(beside, "body#2").bones.size(), 1u);
    EXPECT_EQ(import(beside, ALL_SKELETONS).bones.size(), expected.bones.size() + 3);
    // In other files a bone beside a figure is its prop.
    EditedGlb props(toGlb(models));
    EXPECT_EQ(import(props).bones.size(), expected.bones.size() + 3);
}

}  // namespace
}  // namespace knuckle::test
