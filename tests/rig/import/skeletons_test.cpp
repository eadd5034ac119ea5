#include <gtest/gtest.h>

#include "sim/rig/gltf/glb.h"
#include "sim/rig/import/import.h"
#include "tests/message_of.h"
#include "tests/rig/import/chain.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

std::vector<std::string> boneNames(const Model& model)
{
    std::vector<std::string> names;
    for (const Bone& bone : model.bones) names.push_back(bone.name);
    return names;
}

std::string shift(float x, float y)
{
    return "1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, " + std::to_string(x) + ", " + std::to_string(y) + ", 0, 1;;";
}

/// A chain of three bones in the format of a DirectX file, the first at x, with two meshes that all three move.
/// @param top "2": their height.
std::string chainOfX(float x, const std::string& top)
{
    std::string text = "Frame root { FrameTransformMatrix { " + shift(x, 0) +
                       " } Frame root1 { FrameTransformMatrix { " + shift(0, 1) +
                       " } Frame root2 { FrameTransformMatrix { " + shift(0, 1) + " } } } }\n";
    for (const char* name : {"body", "coat"}) {
        text += std::string("Frame ") + name + " { FrameTransformMatrix { " + shift(0, 0) + " }\nMesh { 4; ";
        for (const std::string& place :
             {std::string("0;0;0;, "), std::string("0.5;1;0;, "), "0;" + top + ";0;, ", std::string("0;1;0.5;; ")}) {
            text += std::to_string(x + std::stof(place)) + place.substr(place.find(';'));
        }
        text += "4; 3;0,2,1;, 3;0,1,3;, 3;1,2,3;, 3;0,3,2;;\nXSkinMeshHeader { 1; 1; 3; }\n";
        for (int b = 0; b < 3; ++b)
            text += "SkinWeights { \"root" + (b == 0 ? std::string() : std::to_string(b)) + "\"; 1; " +
                    std::to_string(b) + "; 1.0; " + shift(-x, -static_cast<float>(b)) + " }\n";
        text += "} }\n";
    }
    return text;
}

class Skeletons : public testing::Test {
protected:
    std::string write(const std::vector<Model>& models) const { return folder_.write("several.glb", toGlb(models)); }
    Model import(const std::vector<Model>& models, const std::string& skeleton, bool surface = false) const
    {
        ImportOptions options;
        options.surface = surface;
        options.pick.skeleton = skeleton;
        return importModel(write(models), options);
    }
    /// The error message without the file's path.
    std::string refusal(const std::vector<Model>& models, const std::string& skeleton) const
    {
        const std::string message = test::messageOf<SkeletonError>([&] { import(models, skeleton); });
        const size_t end = message.find(".glb: ");
        return end == std::string::npos ? message : message.substr(end + 6);
    }
    test::TempFolder folder_;
};

TEST_F(Skeletons, OfTwoFiguresOneMustBeChosen)
{
    const std::vector<Model> models{chain("left", 3, -1), chain("right", 4, 1)};
    EXPECT_EQ(refusal(models, ""), "it holds 2 skeletons: left (3 bones), right (4 bones)");
    EXPECT_EQ(refusal(models, "middle"), "it has no skeleton 'middle', but left (3 bones), right (4 bones)");
    EXPECT_EQ(boneNames(import(models, "r*t")), (std::vector<std::string>{"right", "right1", "right2", "right3"}));
    EXPECT_EQ(import(models, "*").bones.size(), 7u);
}

TEST_F(Skeletons, OneOfTwoIsAsIfItWereAlone)
{
    std::vector<Model> models{chain("root", 3, -1), chain("root", 3, 1)};
    models[0].clips = {clipOf(models[0], "nod", 0.5f), clipOf(models[0], "bow", 1.0f)};
    models[1].clips = {clipOf(models[1], "nod", 0.8f)};
    models[0].surface.materials = {{.name = "one"}};
    models[1].surface.materials = {{.name = "two"}};
    for (Model& model : models) model.surface.vertices.resize(model.vertices.size());
    for (const size_t figure : {size_t{0}, size_t{1}}) {
        const Model picked = import(models, figure == 0 ? "root" : "root#2", true);
        const Model alone = import({models[figure]}, "", true);
        EXPECT_EQ(boneNames(picked), boneNames(alone));
        EXPECT_EQ(picked.vertices, alone.vertices);
        EXPECT_EQ(picked.triangles, alone.triangles);
        ASSERT_EQ(picked.clips.size(), models[figure].clips.size());
        EXPECT_EQ(picked.clips[0].poses, alone.clips[0].poses);
        ASSERT_EQ(picked.surface.materials.size(), 1u);
        EXPECT_EQ(picked.surface.materials[0].name, figure == 0 ? "one" : "two");
    }
}

TEST_F(Skeletons, MeshesOfFiguresWithTheSameNamesGoToTheirOwn)
{
    const std::string path = folder_.write("pair.x", "xof 0303txt 0032\n" + chainOfX(-1, "2") + chainOfX(1, "3"));
    for (const float side : {-1.0f, 1.0f}) {
        ImportOptions options;
        options.pick.skeleton = side < 0.0f ? "root" : "root#2";
        const Model model = importModel(path, options);
        EXPECT_EQ(model.bones.size(), 3u);
        EXPECT_EQ(model.triangles.size(), 8u) << "body and coat";
        for (const Vector3f& v : model.vertices) {
            EXPECT_GE(side * v.x(), 0.5f) << v.transpose();
            if (v.y() < 1.5f) continue;
            EXPECT_NEAR(v.y(), side < 0.0f ? 2.0f : 3.0f, 1e-4f);
        }
    }
}

TEST_F(Skeletons, AMeshThatSpansTwoTreesJoinsThem)
{
    Model both = chain("upper", 3, 0);
    const Model lower = chain("lower", 3, 1);
    const auto firstVertex = static_cast<uint32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), lower.vertices.begin(), lower.vertices.end());
    for (const Triangle& t : lower.triangles)
        both.triangles.push_back({t[0] + firstVertex, t[1] + firstVertex, t[2] + firstVertex});
    for (SkinWeights skin : lower.skin) {
        skin.bones[0] += 3;
        both.skin.push_back(skin);
    }
    for (Bone bone : lower.bones) {
        bone.parent = bone.parent < 0 ? -1 : bone.parent + 3;
        both.bones.push_back(bone);
    }
    EXPECT_EQ(import({both}, "").bones.size(), 6u);
    EXPECT_EQ(refusal({both}, "lower"), "it has no skeleton 'lower', but one: upper (6 bones)");
}

TEST_F(Skeletons, PropsAndControlsMakeNoFigure)
{
    EXPECT_EQ(import({chain("hips", 4, 0), chain("sword", 2, 1), chain("control", 1, 2)}, "").bones.size(), 7u);
}

TEST_F(Skeletons, WhatHasNoneHasNone)
{
    const std::string path = folder_.write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"
                                                      "f 1 4 3\n");
    ImportOptions options;
    options.pick.skeleton = "hips";
    EXPECT_EQ(test::messageOf<SkeletonError>([&] { importModel(path, options); }), path + ": it has no skeleton");
    options.pick.skeleton = "*";
    EXPECT_EQ(importModel(path, options).triangles.size(), 4u);
}

}  // namespace
}  // namespace knuckle
