#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "sim/rig/import/import.h"
#include "tests/rig/import/chain.h"
#include "tests/rig/import/edited_glb.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;
using Json = nlohmann::json;
using test::EditedGlb;

/// Contents of a scene and their motion.
class GltfScenes : public testing::Test {
protected:
    Model import(EditedGlb& glb) const { return importModel(folder_.write("scene.glb", glb.bytes())); }
    /// A chain that nods to one side.
    static Model nodding()
    {
        Model model = chain("hips", 3, 0.25f);
        model.clips = {clipOf(model, "nod", 0.0f)};
        model.clips[0].poses.back().back().topLeftCorner<3, 3>() =
            Eigen::AngleAxisf(0.75f, Vector3f::UnitZ()).toRotationMatrix();
        return model;
    }
    /// Puts everything in a scene below one node.
    static Json& below(EditedGlb& glb, const Json& node)
    {
        Json holder = node;
        holder["children"] = glb.root["scenes"][0]["nodes"];
        glb.root["nodes"].push_back(holder);
        glb.root["scenes"][0]["nodes"] = {glb.root["nodes"].size() - 1};
        return glb.root["nodes"].back();
    }
    static void addToScene(EditedGlb& glb, size_t node) { glb.root["scenes"][0]["nodes"].push_back(node); }
    /// Appends a clip with several keys of a node: linear, or with an `interpolation`.
    static void addClip(EditedGlb& glb, size_t node, const std::string& path, const std::vector<float>& times,
                        const std::vector<float>& values, const std::string& interpolation = "LINEAR")
    {
        const size_t input = glb.add(times, 1, 5126, "SCALAR");
        const bool isTurn = path == "rotation";
        const size_t output = glb.add(values, isTurn ? 4 : 3, 5126, isTurn ? "VEC4" : "VEC3");
        Json clip;
        clip["name"] = "move";
        clip["samplers"] = {{{"input", input}, {"output", output}, {"interpolation", interpolation}}};
        clip["channels"] = {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}};
        glb.root["animations"].push_back(clip);
    }
    static Eigen::AlignedBox3f boundsOf(const Model& model)
    {
        Eigen::AlignedBox3f box;
        for (const Vector3f& v : model.vertices) box.extend(v);
        return box;
    }
    static float volumeOf(const Model& model)
    {
        float sum = 0.0f;
        for (const auto& [a, b, c] : model.triangles)
            sum += model.vertices[a].dot(model.vertices[b].cross(model.vertices[c])) / 6.0f;
        return sum;
    }
    test::TempFolder folder_;
};

TEST_F(GltfScenes, AFileWithoutASceneShowsAllOfItsNodes)
{
    EditedGlb glb(toGlb(nodding()));
    const Model wanted = import(glb);
    glb.root.erase("scene");
    glb.root.erase("scenes");
    const Model model = import(glb);
    EXPECT_EQ(model.vertices, wanted.vertices);
    EXPECT_EQ(model.bones.size(), 3u);
}

TEST_F(GltfScenes, AMirroredFigureLooksAndMovesAsItsImage)
{
    EditedGlb plain(toGlb(nodding())), turned(toGlb(nodding()));
    below(turned, {{"scale", {-1, 1, 1}}});
    const Model model = import(plain), image = import(turned);
    const Matrix4f mirror = Eigen::Vector4f(-1, 1, 1, 1).asDiagonal();
    ASSERT_EQ(image.vertices.size(), model.vertices.size());
    for (size_t v = 0; v < model.vertices.size(); ++v)
        EXPECT_LT(
            (image.vertices[v] - Vector3f(-model.vertices[v].x(), model.vertices[v].y(), model.vertices[v].z())).norm(),
            1e-5f);
    EXPECT_GT(volumeOf(model), 0.0f);
    EXPECT_NEAR(volumeOf(image), volumeOf(model), 1e-4f);
    for (size_t b = 0; b < model.bones.size(); ++b) {
        EXPECT_GT(image.bones[b].restPose.determinant(), 0.0f);
        const Matrix4f turn = model.clips[0].poses.back()[b] * model.bones[b].restPose.inverse();
        const Matrix4f imageTurn = image.clips[0].poses.back()[b] * image.bones[b].restPose.inverse();
        EXPECT_LT((imageTurn - mirror * turn * mirror).norm(), 1e-4f) << b;
    }
}

TEST_F(GltfScenes, AMirroredBoneIsTurnedRoundAlone)
{
    EditedGlb glb(toGlb(nodding()));
    for (Json& node : glb.root["nodes"])
        if (node.value("name", "") == "hips2") node["scale"] = {1, 1, -1};
    const Model model = import(glb);
    EXPECT_NEAR(volumeOf(model), 3 * 0.2f * 0.2f * 0.5f, 1e-4f);
    EXPECT_GT(model.bones[2].restPose.determinant(), 0.0f);
    EXPECT_GT(model.clips[0].poses.back()[2].determinant(), 0.0f);
}

TEST_F(GltfScenes, AFloorIsNoPartOfAFigure)
{
    EditedGlb glb(toGlb(nodding()));
    addToScene(glb, glb.addMesh("Floor", boxMesh({0, -0.05f, 0}, {2, 0.05f, 2})));
    addToScene(glb, glb.addMesh("Pedestal", boxMesh({0.25f, -0.05f, 0}, {0.15f, 0.05f, 0.15f})));
    addToScene(glb, glb.addMesh("Eyes", boxMesh({0.25f, 1.4f, 0.1f}, {0.05f, 0.02f, 0.02f})));
    addToScene(glb, glb.addMesh("Hat", boxMesh({0.25f, 1.55f, 0}, {0.15f, 0.1f, 0.15f})));
    const Model model = import(glb);
    EXPECT_EQ(model.notes,
              (std::vector<std::string>{"Mesh 'Floor' hangs on no bone and lies apart from the figure: left out.",
                                        "Mesh 'Pedestal' hangs on no bone and lies apart from the figure: left out."}));
    EXPECT_EQ(model.vertices.size(), size_t{8 * 5});
    EXPECT_NEAR(boundsOf(model).max().y(), 1.65f, 1e-5f);
    ImportOptions all;
    all.pick.skeleton = ALL_SKELETONS;
    EXPECT_EQ(importModel(folder_.write("scene.glb", glb.bytes()), all).vertices.size(), size_t{8 * 7});
}

TEST_F(GltfScenes, PartsThatClipsMoveAreBones)
{
    EditedGlb glb(toGlb(chain("unused", 1, 0)));
    glb.root["nodes"] = glb.root["meshes"] = Json::array();
    glb.root.erase("skins");
    const size_t trunk = glb.addMesh("Trunk", boxMesh({0, 0.5f, 0}, {0.2f, 0.5f, 0.2f}));
    const size_t arm = glb.addMesh("Arm", boxMesh({0.3f, 0, 0}, {0.3f, 0.1f, 0.1f}));
    glb.root["nodes"][arm]["translation"] = {0.2, 0.9, 0};
    const size_t eye = glb.addMesh("Eye", boxMesh({0, 0.8f, 0.2f}, {0.05f, 0.05f, 0.05f}));
    glb.root["nodes"][trunk]["children"] = {arm, eye};
    glb.root["scenes"][0]["nodes"] = {trunk};
    EXPECT_TRUE(import(glb).bones.empty()) << "without a clip it is one body";
    addClip(glb, arm, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f});
    const Model model = import(glb);
    ASSERT_EQ(model.bones.size(), 2u);
    EXPECT_EQ(model.bones[0].name, "Trunk");
    EXPECT_EQ(model.bones[1].name, "Arm");
    EXPECT_EQ(model.bones[1].parent, 0);
    ASSERT_EQ(model.skin.size(), 24u);
    EXPECT_EQ(model.skin[8].bones[0], 1u) << "the arm";
    EXPECT_EQ(model.skin[16].bones[0], 0u) << "the eye";
    ASSERT_EQ(model.clips.size(), 1u);
    const Vector3f tip = (model.clips[0].poses.back()[1] * Eigen::Vector4f(0.6f, 0, 0, 1)).head<3>();
    EXPECT_LT((tip - Vector3f(0.2f, 1.5f, 0)).norm(), 1e-4f);
    EXPECT_EQ(model.notes, std::vector<std::string>{"No mesh has a skeleton: of what clips move 2 bones were made."});

    ImportOptions split;
    split.pick.split = true;
    EXPECT_EQ(importModel(folder_.write("scene.glb", glb.bytes()), split).bones.size(), 3u);
}

TEST_F(GltfScenes, KeysJumpOrFollowCurves)
{
    for (const bool isStep : {true, false}) {
        Model figure = nodding();
        figure.clips.clear();
        EditedGlb glb(toGlb(figure));
        size_t hips = 0;
        while (glb.root["nodes"].at(hips).value("name", "") != "hips") ++hips;
        if (isStep) addClip(glb, hips, "translation", {0, 1, 2}, {0, 0, 0, 0, 1, 0, 0, 5, 0}, "STEP");
        // In slope, value, out slope: level at both ends.
        else
            addClip(glb, hips, "translation", {0, 1}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0},
                    "CUBICSPLINE");
        const Clip clip = import(glb).clips.at(0);
        const auto heightAt = [&](double time) {
            const auto key = std::ranges::min_element(clip.keyTimes, {},
                                                      [&](double keyTime) { return std::abs(keyTime - time); });
            return clip.poses[static_cast<size_t>(key - clip.keyTimes.begin())][0](1, 3);
        };
        EXPECT_NEAR(clip.duration, isStep ? 2.0 : 1.0, 1e-6);
        EXPECT_NEAR(heightAt(0.25), isStep ? 0.0f : 0.15625f, 2e-3f);
        EXPECT_NEAR(heightAt(0.75), isStep ? 0.0f : 0.84375f, 2e-3f);
        EXPECT_NEAR(heightAt(clip.duration), isStep ? 5.0f : 1.0f, 1e-5f);
        EXPECT_NEAR(heightAt(1.5), 1.0f, 1e-5f) << "or the last key";
    }
}

TEST_F(GltfScenes, ShapesInUseFromTheStartAreApplied)
{
    EditedGlb glb(toGlb(chain("hips", 3, 0)));
    std::vector<float> shift(3 * 24, 0.0f);
    for (size_t v = 16; v < 24; ++v) shift[3 * v + 1] = 1.0f;
    glb.primitive()["targets"] = {{{"POSITION", glb.add(shift, 3, 5126, "VEC3")}}};
    glb.root["meshes"][0]["weights"] = {0.5};
    EXPECT_NEAR(boundsOf(import(glb)).max().y(), 2.0f, 1e-5f);
    for (Json& node : glb.root["nodes"])
        if (node.contains("mesh")) node["weights"] = {0.25};
    EXPECT_NEAR(boundsOf(import(glb)).max().y(), 1.75f, 1e-5f);
}

TEST_F(GltfScenes, AFileWithOtherLettersIsChangedAsOthersAre)
{
    EditedGlb glb(toGlb(chain("hips", 3, 0)));
    glb.root["skins"][0].erase("inverseBindMatrices");
    std::string bytes = glb.bytes();
    bytes[bytes.find("hips1") + 1] = '\xfc';
    EXPECT_EQ(importModel(folder_.write("letters.glb", bytes)).bones.at(1).name, "h\xc3\xbcps1");
}

TEST_F(GltfScenes, NamesInOtherLettersBecomeText)
{
    const std::string path = folder_.write(
        "old.bvh", "HIERARCHY\nROOT H\xfc"
                   "fte\n{\n OFFSET 0 90 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n JOINT "
                   "Br\xc3\xbcst\n {\n  OFFSET 0 40 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n  End Site\n  {\n   "
                   "OFFSET 0 40 0\n  }\n }\n}\nMOTION\nFrames: 1\nFrame Time: 0.05\n0 0 0 0 0 0\n");
    const Model model = importModel(path);
    ASSERT_GE(model.bones.size(), 2u);
    EXPECT_EQ(model.bones[0].name, "H\xc3\xbc"
                                   "fte");
    EXPECT_EQ(model.bones[1].name, "Br\xc3\xbcst");
    EXPECT_FALSE(toGlb(model).empty());
}

}  // namespace
}  // namespace knuckle
