#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "sim/actor/import/model.h"
#include "sim/actor/import/model_bytes.h"
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

/// A square in the plane of x and y with a corner of the picture at each of its own; no normals.
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
    static bool notes(const Model& model, const std::string& text)
    {
        return std::ranges::find(model.surface.notes, text) != model.surface.notes.end();
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

TEST_F(Surface, ADamagedTextureIsANoteAndItsMaterialPlain)
{
    write("paint.tga", smallPicture().substr(0, 10));
    const Model model = square("Kd 1 0 0\nmap_Kd paint.tga\n");
    EXPECT_TRUE(model.surface.textures.empty());
    EXPECT_EQ(model.surface.materials[0].texture, NO_INDEX);
    EXPECT_EQ(model.surface.materials[0].color, Eigen::Vector3f(1, 0, 0));
    EXPECT_TRUE(notes(model, "Texture 'paint.tga' is damaged or of a kind that is not read (PNG, JPEG, TGA, BMP and "
                             "PSD are): drawn plain."));
}

TEST_F(Surface, AMissingTextureIsANote)
{
    const Model model = square("map_Kd paint.tga\n");
    EXPECT_EQ(model.surface.materials[0].texture, NO_INDEX);
    EXPECT_TRUE(notes(model, "Texture 'paint.tga' is not there: drawn plain."));
}

TEST_F(Surface, NobodyAsksNobodyReads)
{
    square("map_Kd paint.tga\n");
    const Model model = importModel(folder_.path("square.obj"));
    EXPECT_TRUE(model.surface.vertices.empty());
    EXPECT_TRUE(model.surface.notes.empty());
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
