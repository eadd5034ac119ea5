#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "sim/rig/gltf/glb.h"
#include "sim/rig/import/import.h"
#include "sim/rig/import/model_bytes.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// A square of 2 x 2 pixels: red, green; blue, white. TGA, rows from the bottom.
std::string smallPicture()
{
    std::string tga(18, '\0');
    tga[2] = 2;
    tga[12] = tga[14] = 2;
    tga[16] = 24;
    for (const auto& bgr : {"\xff\x00\x00", "\xff\xff\xff", "\x00\x00\xff", "\x00\xff\x00"}) tga += std::string(bgr, 3);
    return tga;
}

/// A square in the x-y plane with a corner of the picture at each of its corners; no normals.
const char* const SQUARE = "mtllib looks.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

class Surface : public testing::Test {
protected:
    Model square(const std::string& material) const
    {
        write("looks.mtl", "newmtl paint\n" + material);
        write("square.obj", SQUARE);
        ImportOptions options;
        options.surface = true;
        return importModel(folder_.path("square.obj"), options);
    }
    void write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(folder_.path(name), std::ios::binary) << bytes;
    }
    /// The material of a triangle.
    SkinMaterial lookOf(const std::string& gltf) const
    {
        const std::array<float, 21> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0.5f, 2, 0.5f, 1, 1};
        write("shifted.gltf", gltf);
        write("shifted.bin", {reinterpret_cast<const char*>(numbers.data()), sizeof numbers});
        ImportOptions options;
        options.surface = true;
        return importModel(folder_.path("shifted.gltf"), options).surface.materials.at(0);
    }
    static bool isMissing(const Model& model, const std::string& text)
    {
        return std::ranges::find(model.surface.missing, text) != model.surface.missing.end();
    }
    test::TempFolder folder_;
};

TEST_F(Surface, ATextureBesideTheModelIsDecoded)
{
    write("paint.tga", smallPicture());
    const Model model = square("Kd 1 1 1\nmap_Kd C:\\art\\paint.tga\n");
    ASSERT_EQ(model.surface.textures.size(), 1u);
    const TexturePicture& picture = model.surface.textures[0];
    EXPECT_EQ(picture.width, 2u);
    const std::vector<uint8_t> topRow(picture.rgba.begin(), picture.rgba.begin() + 8);
    EXPECT_EQ(topRow, (std::vector<uint8_t>{255, 0, 0, 255, 0, 255, 0, 255}));
    ASSERT_EQ(model.surface.vertices.size(), model.vertices.size());
    for (size_t v = 0; v < model.vertices.size(); ++v) {
        const SurfaceVertex& vertex = model.surface.vertices[v];
        // v of the picture grows downwards.
        EXPECT_EQ(vertex.uv, Eigen::Vector2f(model.vertices[v].x(), 1.0f - model.vertices[v].y()));
        EXPECT_NEAR((vertex.normal - Eigen::Vector3f(0, 0, 1)).norm(), 0.0f, 1e-6f);
    }
    ASSERT_EQ(model.surface.materials.size(), 1u);
    EXPECT_EQ(model.surface.materials[0].texture, 0u);
    EXPECT_TRUE(model.surface.materials[0].twoSided);
}

TEST_F(Surface, APictureMayEndAtItsEdges)
{
    write("paint.tga", smallPicture());
    const SkinMaterial material = square("map_Kd -clamp on paint.tga\n").surface.materials.at(0);
    EXPECT_EQ(material.wrap, (std::array{TextureWrap::Clamp, TextureWrap::Clamp}));
}

TEST_F(Surface, WhatAPicturesAlphaLeavesOutIsNotThere)
{
    write("paint.tga", smallPicture());
    EXPECT_EQ(square("map_Kd paint.tga\n").surface.materials.at(0).alphaCutoff, 0.0f);
    EXPECT_EQ(square("map_Kd paint.tga\nmap_d paint.tga\n").surface.materials.at(0).alphaCutoff, 0.5f);
}

/// A triangle whose second channel of places is 1, 0.5; 2, 0.5; 1, 1; the material doubles it, turns it by a quarter
/// anticlockwise about the picture's upper left corner and shifts it.
const char* const SHIFTED = R"({ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }],
    "nodes": [{ "mesh": 0 }], "buffers": [{ "uri": "shifted.bin", "byteLength": 84 }],
    "bufferViews": [{ "buffer": 0, "byteLength": 36 }, { "buffer": 0, "byteOffset": 36, "byteLength": 24 },
                    { "buffer": 0, "byteOffset": 60, "byteLength": 24 }],
    "accessors": [
        { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0] },
        { "bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2" },
        { "bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2" }],
    "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2 },
                                  "material": 0 }] }],
    "images": [{ "uri": "paint.tga" }], "samplers": [{ "wrapS": 33648, "wrapT": 33071 }],
    "textures": [{ "source": 0, "sampler": 0 }], "extensionsUsed": ["KHR_texture_transform"],
    "materials": [{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0, "texCoord": 1, "extensions": {
        "KHR_texture_transform": { "offset": [0.25, -0.5], "scale": [2, 2],
                                   "rotation": 1.57079633 } } } } }] })";

TEST_F(Surface, APictureIsShiftedAndWrappedAsItsMaterialSays)
{
    write("paint.tga", smallPicture());
    write("shifted.gltf", SHIFTED);
    const std::array<float, 21> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0.5f, 2, 0.5f, 1, 1};
    write("shifted.bin", {reinterpret_cast<const char*>(numbers.data()), sizeof numbers});
    ImportOptions options;
    options.surface = true;
    const Model model = importModel(folder_.path("shifted.gltf"), options);
    const SkinMaterial& material = model.surface.materials.at(0);
    EXPECT_EQ(material.texture, 0u);
    EXPECT_EQ(material.wrap, (std::array{TextureWrap::Mirror, TextureWrap::Clamp}));
    const std::array<Eigen::Vector2f, 3> places{{{1.25f, -2.5f}, {1.25f, -4.5f}, {2.25f, -2.5f}}};
    ASSERT_EQ(model.surface.vertices.size(), places.size());
    for (size_t v = 0; v < places.size(); ++v)
        EXPECT_LT((model.surface.vertices[v].uv - places[v]).norm(), 1e-5f) << model.surface.vertices[v].uv;

    GlbOptions glb;
    glb.encode = [](const TexturePicture&) { return smallPicture(); };
    write("back.glb", toGlb(std::span(&model, 1), glb));
    const Model back = importModel(folder_.path("back.glb"), options);
    EXPECT_EQ(back.surface.materials.at(0).wrap, material.wrap);
}

/// The triangle without its second places and its picture, with a material of that JSON.
std::string trianglePainted(const std::string& material)
{
    std::string text = SHIFTED;
    const size_t start = text.find("\"materials\": [");
    return text.substr(0, start) + "\"materials\": [" + material + "] }";
}

TEST_F(Surface, APicturesNameMayBeWrittenAsAnUri)
{
    write("my paint.tga", smallPicture());
    std::string text = SHIFTED;
    EXPECT_EQ(lookOf(text.replace(text.find("paint.tga"), 9, "my%20paint.tga")).texture, 0u);
}

TEST_F(Surface, AlphaOfTheColorCountsForCutoffs)
{
    write("paint.tga", smallPicture());
    const std::string picture = "\"baseColorTexture\": { \"index\": 0 }, ";
    const auto cutoff = [&](const std::string& mode, const std::string& of, const std::string& alpha) {
        return lookOf(trianglePainted("{ \"alphaMode\": " + mode + ", \"pbrMetallicRoughness\": { " + of +
                                      "\"baseColorFactor\": [1, 1, 1, " + alpha + "] } }"))
            .alphaCutoff;
    };
    const std::string mask = "\"MASK\", \"alphaCutoff\": 0.25", blend = "\"BLEND\"";
    EXPECT_FLOAT_EQ(cutoff(mask, picture, "1"), 0.25f);
    EXPECT_FLOAT_EQ(cutoff(mask, picture, "0.5"), 0.5f);
    EXPECT_GT(cutoff(mask, picture, "0.2"), 1.0f) << "nothing is left";
    EXPECT_FLOAT_EQ(cutoff(blend, picture, "0.8"), 0.625f);
    EXPECT_GT(cutoff(blend, "", "0.4"), 1.0f);
    EXPECT_GT(cutoff(mask, "", "0"), 1.0f);
    EXPECT_EQ(cutoff(blend, "", "0.8"), 0.0f);
    EXPECT_EQ(cutoff("\"OPAQUE\"", "", "0.1"), 0.0f);
}

TEST_F(Surface, ColorsOfOldAndOfGlowingMaterialsAreTaken)
{
    const std::string old = "{ \"extensions\": { \"KHR_materials_pbrSpecularGlossiness\": { \"diffuseFactor\": "
                            "[0.25, 0.5, 0, 1] } } }";
    EXPECT_EQ(lookOf(trianglePainted(old)).color, Eigen::Vector3f(0.25f, 0.5f, 0));
    const std::string glow = "\"emissiveFactor\": [0, 0.5, 1], \"pbrMetallicRoughness\": { \"baseColorFactor\": ";
    EXPECT_EQ(lookOf(trianglePainted("{ " + glow + "[0, 0, 0, 1] } }")).color, Eigen::Vector3f(0, 0.5f, 1));
    EXPECT_EQ(lookOf(trianglePainted("{ " + glow + "[1, 0, 0, 1] } }")).color, Eigen::Vector3f(1, 0, 0));
}

TEST_F(Surface, KnowsFactorsOfMetalnessAndRoughness)
{
    const SkinMaterial brass = lookOf(
        trianglePainted("{ \"pbrMetallicRoughness\": { \"metallicFactor\": 0.75, \"roughnessFactor\": 0.25 } }"));
    EXPECT_FLOAT_EQ(brass.metalness, 0.75f);
    EXPECT_FLOAT_EQ(brass.roughness, 0.25f);
}

TEST_F(Surface, KnowsPicturesOfNormalsAndRoughnesses)
{
    write("paint.tga", smallPicture());
    const SkinMaterial bumped = lookOf(trianglePainted(
        R"({ "normalTexture": { "index": 0, "scale": 0.5 },
             "pbrMetallicRoughness": { "metallicRoughnessTexture": { "index": 0 } } })"));
    EXPECT_EQ(bumped.texture, NO_INDEX);
    EXPECT_EQ(bumped.normals, 0u);
    EXPECT_EQ(bumped.roughnesses, 0u);
    EXPECT_EQ(bumped.normalScale, 0.5f);
    // Other places than those of the colours are not kept.
    EXPECT_EQ(lookOf(trianglePainted(R"({ "normalTexture": { "index": 0, "texCoord": 1 } })")).normals, NO_INDEX);
}

TEST_F(Surface, ADamagedTextureIsANoteAndItsMaterialPlain)
{
    write("paint.tga", smallPicture().substr(0, 10));
    const Model model = square("Kd 1 0 0\nmap_Kd paint.tga\n");
    EXPECT_TRUE(model.surface.textures.empty());
    EXPECT_EQ(model.surface.materials[0].texture, NO_INDEX);
    EXPECT_EQ(model.surface.materials[0].color, Eigen::Vector3f(1, 0, 0));
    EXPECT_TRUE(isMissing(model,
                          "Texture 'paint.tga' is damaged or of a kind that is not read (PNG, JPEG, WebP, TGA, BMP "
                          "and PSD are): drawn plain."));
}

TEST_F(Surface, AMissingTextureIsANote)
{
    const Model model = square("map_Kd paint.tga\n");
    EXPECT_EQ(model.surface.materials[0].texture, NO_INDEX);
    EXPECT_TRUE(isMissing(model, "Texture 'paint.tga' is not there: drawn plain."));
}

TEST_F(Surface, NobodyAsksNobodyReads)
{
    square("map_Kd paint.tga\n");
    const Model model = importModel(folder_.path("square.obj"));
    EXPECT_TRUE(model.surface.vertices.empty());
    EXPECT_TRUE(model.surface.notes.empty());
    EXPECT_TRUE(model.surface.missing.empty());
}

TEST_F(Surface, BytesWithATextureOfAnotherSizeAreNoModel)
{
    write("paint.tga", smallPicture());
    Model model = square("map_Kd paint.tga\n"), back;
    EXPECT_TRUE(fromBytes(toBytes(model), back));
    EXPECT_EQ(back.surface.textures[0].rgba, model.surface.textures[0].rgba);
    model.surface.textures[0].rgba.pop_back();
    EXPECT_FALSE(fromBytes(toBytes(model), back));
}

TEST(TexturePicture, HalfOfItHasTheMeanOfFourPixels)
{
    const TexturePicture half = halved({2, 2, {0, 9, 90, 0, 0, 9, 90, 255, 0, 9, 90, 255, 100, 9, 90, 255}});
    EXPECT_EQ(half.width, 1u);
    // Of squares: sqrt(100^2 / 4).
    EXPECT_EQ(half.rgba, (std::vector<uint8_t>{50, 9, 90, 191}));
    EXPECT_EQ(halved({1, 4, std::vector<uint8_t>(16, 7)}).height, 2u);
}

}  // namespace
}  // namespace knuckle
