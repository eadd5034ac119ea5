#include <gtest/gtest.h>
#include <webp/encode.h>

#include <algorithm>

#include "sim/rig/import/import.h"
#include "tests/rig/import/chain.h"
#include "tests/rig/import/edited_glb.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Json = nlohmann::json;
using test::EditedGlb;

constexpr int SIDE = 4;  // of pictures [pixels]

/// A square, red above and blue below.
std::vector<uint8_t> pixels()
{
    std::vector<uint8_t> rgba;
    for (int i = 0; i < SIDE * SIDE; ++i) {
        const bool isAbove = i < SIDE * SIDE / 2;
        rgba.insert(rgba.end(), {uint8_t(isAbove ? 255 : 0), 0, uint8_t(isAbove ? 0 : 255), uint8_t(200 + i)});
    }
    return rgba;
}

std::string webp()
{
    uint8_t* bytes = nullptr;
    const size_t size = WebPEncodeLosslessRGBA(pixels().data(), SIDE, SIDE, 4 * SIDE, &bytes);
    std::string file(reinterpret_cast<const char*>(bytes), size);
    WebPFree(bytes);
    return file;
}

/// A green pixel. TGA.
std::string tga()
{
    std::string file(18, '\0');
    file[2] = 2;
    file[12] = file[14] = 1;
    file[16] = 24;
    return file + std::string("\0\xff\0", 3);
}

const std::string KTX2 = std::string("\xabKTX 20\xbb\r\n\x1a\n", 12) + std::string(68, '\0');

/// Import of the texture of a chain.
class GltfPictures : public testing::Test {
protected:
    /// @param texture its JSON. @param images their bytes.
    Model import(const Json& texture, const std::vector<std::string>& images) const
    {
        EditedGlb glb(toGlb(paintedChain()));
        for (const std::string& bytes : images) {
            glb.add(std::vector<char>(bytes.begin(), bytes.end()), 1, 5120, "SCALAR");
            glb.root["accessors"].erase(glb.root["accessors"].size() - 1);
            glb.root["images"].push_back(
                {{"bufferView", glb.root["bufferViews"].size() - 1}, {"mimeType", "image/png"}});
        }
        return importTextured(glb, texture);
    }
    Model importTextured(EditedGlb& glb, const Json& texture) const
    {
        glb.root["textures"] = Json::array({texture});
        glb.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
        ImportOptions options;
        options.surface = true;
        return importModel(folder_.write("painted.glb", glb.bytes()), options);
    }
    static Json only(const char* extension, size_t image = 0)
    {
        return {{"extensions", {{extension, {{"source", image}}}}}};
    }
    test::TempFolder folder_;
};

TEST_F(GltfPictures, AWebpIsReadWhereItIsTheOnlyPicture)
{
    for (const Json& texture : {only("EXT_texture_webp"), Json{{"source", 0}}}) {
        const Model model = import(texture, {webp()});
        ASSERT_EQ(model.surface.textures.size(), 1u);
        EXPECT_EQ(model.surface.textures[0].rgba, pixels());
        EXPECT_EQ(model.surface.materials.at(0).texture, 0u);
        EXPECT_TRUE(model.surface.missing.empty());
    }
}

TEST_F(GltfPictures, AWebpMayLieBesideTheModel)
{
    EditedGlb glb(toGlb(paintedChain()));
    folder_.write("my paint.webp", webp());
    glb.root["images"] = Json::array({{{"uri", "my%20paint.webp"}}});
    const Model model = importTextured(glb, only("EXT_texture_webp"));
    ASSERT_EQ(model.surface.textures.size(), 1u);
    EXPECT_EQ(model.surface.textures[0].rgba, pixels());
}

TEST_F(GltfPictures, APlainPictureStandsInForThoseOfExtensions)
{
    for (const char* extension : {"EXT_texture_webp", "KHR_texture_basisu"}) {
        Json texture = only(extension);
        texture["source"] = 1;
        const Model model = import(texture, {KTX2, tga()});
        ASSERT_EQ(model.surface.textures.size(), 1u);
        EXPECT_EQ(model.surface.textures[0].rgba, (std::vector<uint8_t>{0, 255, 0, 255}));
        EXPECT_TRUE(model.surface.missing.empty());
    }
}

TEST_F(GltfPictures, WhatIsNotReadIsTold)
{
    const Model basis = import(only("KHR_texture_basisu"), {KTX2});
    EXPECT_EQ(basis.surface.missing,
              (std::vector<std::string>{"Texture 0 is a KTX2 picture, which is not read: drawn plain."}));
    EXPECT_EQ(basis.surface.materials.at(0).texture, NO_INDEX);
    const Model damaged = import(only("EXT_texture_webp"), {webp().substr(0, 30)});
    ASSERT_EQ(damaged.surface.missing.size(), 1u);
    EXPECT_TRUE(damaged.surface.missing[0].ends_with(
        " is damaged or of a kind that is not read (PNG, JPEG, WebP, TGA, BMP and PSD are): drawn plain."))
        << damaged.surface.missing[0];
}

TEST(GltfExtensions, ThatAFileRequiresAndNobodyKnowsAreTold)
{
    const test::TempFolder folder;
    EditedGlb glb(toGlb(paintedChain()));
    const auto notes = [&](const char* list, const Json& names) {
        glb.root.erase("extensionsRequired");
        glb.root[list] = names;
        return importModel(folder.write("odd.glb", glb.bytes())).notes;
    };
    const std::vector<std::string> usual = notes("extensionsUsed", {"VENDOR_rays"});
    EXPECT_EQ(notes("extensionsRequired", {"KHR_materials_unlit", "KHR_texture_transform", "EXT_texture_webp",
                                           "KHR_mesh_quantization", "EXT_meshopt_compression"}),
              usual);
    std::vector<std::string> told = notes("extensionsRequired", {"VENDOR_rays", "KHR_materials_ior", "VENDOR_fur"});
    for (const char* name : {"VENDOR_fur", "VENDOR_rays"}) {
        const auto note = std::ranges::find(told, std::string("The file requires '") + name +
                                                      "', which is not known here: what it stands for is missing.");
        ASSERT_NE(note, told.end()) << name;
        told.erase(note);
    }
    EXPECT_EQ(told, usual);
}

}  // namespace
}  // namespace knuckle
