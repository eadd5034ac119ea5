#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sim/rig/import/gltf/gltf_floats.h"
#include "tests/rig/import/chain.h"
#include "tests/rig/import/edited_glb.h"
#include "tests/rig/import/surface_import.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;
using Json = nlohmann::json;
using test::EditedGlb;

constexpr int BYTE = 5120, UNSIGNED_BYTE = 5121, SHORT = 5122, UNSIGNED_SHORT = 5123;

/// Numbers of glTF that are not floats, or that a file omits or compresses.
class GltfNumbers : public test::SurfaceImport {
protected:
    /// A chain with a clip and places in pictures.
    static EditedGlb figure()
    {
        const Model model = paintedChain();
        EditedGlb glb(toGlb(model));
        std::vector<float> places, colors;
        for (const Vector3f& v : model.vertices) {
            places.insert(places.end(), {v.x() + 0.5f, v.y() / 1.5f});
            colors.insert(colors.end(), {0.25f, v.y() / 1.5f, 1.0f});
        }
        Json& attributes = glb.primitive()["attributes"];
        attributes["TEXCOORD_0"] = glb.add(places, 2, 5126, "VEC2");
        attributes["COLOR_0"] = glb.add(colors, 3, 5126, "VEC3");
        return glb;
    }
    /// Converts the numbers that `reference` names to integers for 0 ... 1 (-1 ... 1).
    template <typename T>
    static void pack(EditedGlb& glb, Json& reference, size_t components, int type, size_t stride = 0)
    {
        std::vector<T> packed;
        for (const float value : glb.floats(reference.get<size_t>(), components))
            packed.push_back(static_cast<T>(std::round(value * static_cast<float>(std::numeric_limits<T>::max()))));
        const std::string kind = glb.root["accessors"].at(reference.get<size_t>())["type"];
        reference = glb.add(packed, components, type, kind, stride);
        glb.root["accessors"].back()["normalized"] = true;
    }
    static void expectAlike(const Model& model, const Model& wanted)
    {
        constexpr float CLOSE = 0.012f;
        ASSERT_EQ(model.vertices.size(), wanted.vertices.size());
        for (size_t v = 0; v < wanted.vertices.size(); ++v) {
            EXPECT_LT((model.vertices[v] - wanted.vertices[v]).norm(), CLOSE) << v;
            EXPECT_LT((model.surface.vertices[v].uv - wanted.surface.vertices[v].uv).norm(), CLOSE) << v;
            EXPECT_LT((model.surface.vertices[v].color - wanted.surface.vertices[v].color).norm(), CLOSE) << v;
            EXPECT_EQ(model.skin[v].bones, wanted.skin[v].bones) << v;
            EXPECT_NEAR(model.skin[v].weights[0], wanted.skin[v].weights[0], CLOSE) << v;
        }
        ASSERT_EQ(model.clips.size(), wanted.clips.size());
        EXPECT_LT((model.clips[0].poses.back().back() - wanted.clips[0].poses.back().back()).norm(), CLOSE);
        EXPECT_EQ(model.notes, wanted.notes);
    }
};

TEST_F(GltfNumbers, BytesAndShortsAreWhatTheyStandFor)
{
    EditedGlb plain = figure();
    const Model wanted = import(plain);
    EditedGlb bytes = figure(), shorts = figure();
    Json &few = bytes.primitive()["attributes"], &more = shorts.primitive()["attributes"];
    pack<uint8_t>(bytes, few["WEIGHTS_0"], 4, UNSIGNED_BYTE);
    pack<uint8_t>(bytes, few["TEXCOORD_0"], 2, UNSIGNED_BYTE, 4);
    pack<int8_t>(bytes, few["NORMAL"], 3, BYTE, 4);
    pack<uint16_t>(shorts, more["WEIGHTS_0"], 4, UNSIGNED_SHORT);
    pack<uint16_t>(shorts, more["TEXCOORD_0"], 2, UNSIGNED_SHORT);
    pack<int16_t>(shorts, more["NORMAL"], 3, SHORT, 8);
    pack<uint8_t>(bytes, few["COLOR_0"], 3, UNSIGNED_BYTE, 4);
    pack<uint16_t>(shorts, more["COLOR_0"], 3, UNSIGNED_SHORT, 8);
    ASSERT_EQ(wanted.surface.vertices[0].color.x(), 0.25f);
    expectAlike(import(bytes), wanted);
    expectAlike(import(shorts), wanted);
}

TEST_F(GltfNumbers, TurnsOfClipsMayBeShorts)
{
    EditedGlb plain = figure(), packed = figure();
    Json& clip = packed.root["animations"].at(0);
    for (const Json& channel : clip["channels"])
        if (channel["target"]["path"] == "rotation")
            pack<int16_t>(packed, clip["samplers"].at(channel["sampler"].get<size_t>())["output"], 4, SHORT);
    const Model wanted = import(plain);
    ASSERT_GT((wanted.clips[0].poses.back().back() - wanted.bones.back().restPose).norm(), 0.1f);
    expectAlike(import(packed), wanted);
}

TEST_F(GltfNumbers, PlacesMayBeShortsThatANodeMakesSmaller)
{
    EditedGlb glb = figure();
    const size_t node = glb.addMesh("cube", boxMesh({1, 1, 1}, {1, 1, 1}));
    glb.primitive(1)["attributes"]["POSITION"] = glb.add(
        std::vector<uint16_t>{0, 0, 0, 500, 0, 0, 0, 500, 0, 0, 0, 500, 500, 500, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 3,
        UNSIGNED_SHORT, "VEC3", 8);
    glb.root["nodes"][node]["scale"] = {0.002, 0.002, 0.002};
    glb.root["scenes"][0]["nodes"] = {node};
    glb.root.erase("skins");
    glb.root.erase("animations");
    for (Json& other : glb.root["nodes"]) other.erase("skin");
    const Model model = import(glb);
    Eigen::AlignedBox3f box;
    for (const Vector3f& v : model.vertices) box.extend(v);
    EXPECT_LT((box.min() - Vector3f(0, 0, 0)).norm() + (box.max() - Vector3f(1, 1, 1)).norm(), 1e-5f);
}

TEST_F(GltfNumbers, SparseOnesReplaceSome)
{
    EditedGlb glb = figure();
    const size_t base = glb.add(std::vector<int8_t>{127, 0, -128, 64}, 1, BYTE, "SCALAR", 4);
    const size_t where = glb.add(std::vector<uint16_t>{2}, 1, UNSIGNED_SHORT, "SCALAR");
    const size_t what = glb.add(std::vector<int8_t>{-127}, 1, BYTE, "SCALAR");
    Json& accessors = glb.root["accessors"];
    accessors[base]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", accessors[where]["bufferView"]}, {"componentType", UNSIGNED_SHORT}}},
        {"values", {{"bufferView", accessors[what]["bufferView"]}}}};
    const std::string path = folder_.write("sparse.glb", glb.bytes());
    const std::unique_ptr<GltfSource> source = GltfSource::open(path);
    ASSERT_TRUE(source);
    EXPECT_EQ(readFloats(*source, base, false).values, (std::vector<float>{127, 0, -127, 64}));
    EXPECT_EQ(readFloats(*source, base, true).values, (std::vector<float>{1, 0, -1, 64.0f / 127.0f}));
    source->root["accessors"][base].erase("bufferView");
    EXPECT_EQ(readFloats(*source, base, false).values, (std::vector<float>{0, 0, -127, 0}));
    source->root["accessors"][base]["count"] = 2;
    EXPECT_THROW(readFloats(*source, base, false), InputError);
}

TEST_F(GltfNumbers, WhatReachesPastItsBufferIsRefused)
{
    EditedGlb many = figure();
    Json& attributes = many.primitive()["attributes"];
    pack<uint8_t>(many, attributes["WEIGHTS_0"], 4, UNSIGNED_BYTE);
    Json& accessor = many.root["accessors"].back();
    accessor["count"] = accessor["count"].get<size_t>() + 1;
    EXPECT_NE(refusal(many).find("past the end of buffer view"), std::string::npos) << refusal(many);
    accessor["count"] = 1000000000000;
    EXPECT_NE(refusal(many).find("simplify"), std::string::npos) << refusal(many);
    accessor["count"] = 1;
    accessor["byteOffset"] = 18446744073709551615u;
    EXPECT_NE(refusal(many).find("past the end"), std::string::npos) << refusal(many);
    accessor["byteOffset"] = 0;
    many.root["bufferViews"].back()["byteLength"] = many.buffer.size() * 2;
    EXPECT_NE(refusal(many).find("past the end of their buffer"), std::string::npos) << refusal(many);
}

TEST_F(GltfNumbers, BindMatricesMayBeLeftOut)
{
    EditedGlb glb = figure();
    glb.root["skins"][0].erase("inverseBindMatrices");
    const Model model = import(glb);
    // Without one, it is in the space of its bones: the uppermost box is one metre higher than before.
    float top = 0.0f;
    for (const Vector3f& v : model.vertices) top = std::max(top, v.y());
    EXPECT_NEAR(top, 1.5f + 0.75f * 1.0f, 1e-3f);

    glb.root["nodes"].push_back({{"name", nullptr}});
    EXPECT_EQ(import(glb).bones.size(), 3u) << "whatever else is wrong";

    EditedGlb few = figure();
    few.root["accessors"].at(few.root["skins"][0]["inverseBindMatrices"].get<size_t>())["count"] = 2;
    EXPECT_NE(refusal(few).find("fewer bind matrices"), std::string::npos) << refusal(few);
}

TEST_F(GltfNumbers, FilesBesideHaveTheNamesThatTheirUrisStandFor)
{
    EditedGlb glb = figure();
    glb.bytes();
    folder_.write("my bones.bin", glb.buffer);
    glb.root["buffers"][0]["uri"] = "my%20bones.bin";
    const std::string path = folder_.write("text.gltf", glb.root.dump());
    EXPECT_EQ(importModel(path).bones.size(), 3u);
    glb.root["buffers"][0]["uri"] = "my%2520bones.bin";
    folder_.write("my%2520bones.bin", glb.buffer);
    EXPECT_EQ(importModel(folder_.write("text.gltf", glb.root.dump())).bones.size(), 3u);
}

}  // namespace
}  // namespace knuckle
