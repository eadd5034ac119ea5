#include <gtest/gtest.h>

#include "render/reader/picture_file.h"
#include "tests/compare/made_files.h"

namespace knuckle::test {
namespace {

TEST(SrgbCurve, GoesOnBeyondItsEnds)
{
    // 1.055 * 4^(1/2.4) - 0.055
    EXPECT_NEAR(encodeSrgb(4.0f), 1.8248f, 1e-3f);
    EXPECT_FLOAT_EQ(encodeSrgb(-0.5f), -encodeSrgb(0.5f));
    for (const float light : {0.0f, 0.001f, 0.2f, 1.0f, 17.0f, 60000.0f, -3.0f})
        EXPECT_NEAR(decodeSrgb(encodeSrgb(light)), light, 1e-5f * std::max(1.0f, std::abs(light)));
}

TEST(ReadJpeg, KeepsColorsAndGrey)
{
    // One colour all over: what is left is the rounding of the colour space.
    std::vector<uint8_t> samples;
    for (int i = 0; i < 16 * 8; ++i) samples.insert(samples.end(), {200, 90, 30});
    const Picture picture = decodePicture(jpegBytes(16, 8, 3, samples), "a.jpg");
    ASSERT_EQ(picture.rgba.size(), size_t{16 * 8 * 4});
    EXPECT_NEAR(picture.rgba[0] * 255, 200, 2.5);
    EXPECT_NEAR(picture.rgba[1] * 255, 90, 2.5);
    EXPECT_NEAR(picture.rgba[2] * 255, 30, 2.5);
    EXPECT_EQ(picture.rgba[3], 1.0f);
    const Picture grey = decodePicture(jpegBytes(16, 8, 1, std::vector<uint8_t>(16 * 8, 77)), "named.png");
    EXPECT_NEAR(grey.rgba[0] * 255, 77, 1.5);
    EXPECT_EQ(grey.rgba[0], grey.rgba[2]);
}

ExrMade rgbExr(int width, int height)
{
    ExrMade made;
    made.width = width;
    made.height = height;
    std::vector<float> red, green, blue;
    for (int i = 0; i < width * height; ++i) {
        red.push_back(static_cast<float>(i) * 0.25f);
        green.push_back(0.5f);
        blue.push_back(static_cast<float>(i % 3) * 8.0f);
    }
    made.channels = {{"R", red}, {"G", green}, {"B", blue}};
    return made;
}

void expectLight(const Picture& picture, size_t pixel, const std::array<float, 4>& light)
{
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(decodeSrgb(picture.rgba[pixel * 4 + c]), light[c], 1e-4f * std::max(1.0f, light[c]))
            << "pixel " << pixel << " channel " << c;
    EXPECT_NEAR(picture.rgba[pixel * 4 + 3], light[3], 1e-6f);
}

TEST(ReadExr, KeepsHalfAndFloatInRowsAndTiles)
{
    for (const bool half : {false, true})
        for (const bool tiled : {false, true}) {
            ExrMade made = rgbExr(21, 18);
            made.half = half;
            made.tiled = tiled;
            const Picture picture = decodePicture(exrBytes(made), "a.exr");
            EXPECT_TRUE(picture.hdr);
            EXPECT_EQ(picture.bitDepth, half ? 16u : 32u);
            for (size_t i = 0; i < size_t{21 * 18}; ++i)
                expectLight(picture, i, {made.channels[0].second[i], 0.5f, made.channels[2].second[i], 1});
        }
}

TEST(ReadExr, TakesLuminanceAlphaAndLayers)
{
    ExrMade made;
    made.width = 2;
    made.channels = {{"Y", {0.5f, 3.0f}}};
    expectLight(decodePicture(exrBytes(made), "a.exr"), 1, {3, 3, 3, 1});
    made.channels = {{"R", {1, 0.25f}}, {"G", {1, 0.5f}}, {"B", {1, 0.125f}}, {"A", {1, 0.5f}}};
    const Picture clear = decodePicture(exrBytes(made), "a.exr");
    EXPECT_TRUE(clear.hasAlpha);
    expectLight(clear, 1, {0.25f, 0.5f, 0.125f, 0.5f});
    made.channels = {{"beauty.R", {1, 2}}, {"beauty.G", {1, 3}}, {"beauty.B", {1, 4}}, {"depth.Z", {9, 9}}};
    expectLight(decodePicture(exrBytes(made), "a.exr"), 1, {2, 3, 4, 1});
}

TEST(ReadExr, PutsItsDataWhereItIsShown)
{
    ExrMade made = rgbExr(4, 3);
    made.left = 2;
    made.top = 1;
    made.shownWidth = 8;
    made.shownHeight = 6;
    Picture picture = decodePicture(exrBytes(made), "a.exr");
    ASSERT_EQ(picture.width, 8u);
    ASSERT_EQ(picture.height, 6u);
    expectLight(picture, 0, {0, 0, 0, 0});
    expectLight(picture, 1 * 8 + 3, {0.25f, 0.5f, 8, 1});
    // Nothing of what lies outside is lost.
    made.left = -3;
    picture = decodePicture(exrBytes(made), "a.exr");
    ASSERT_EQ(picture.width, 11u);
    expectLight(picture, 1 * 11 + 1, {0.25f, 0.5f, 8, 1});
    // A picture of its own place needs no other.
    made.shownWidth = 0;
    made.left = -70;
    made.top = 500;
    picture = decodePicture(exrBytes(made), "a.exr");
    ASSERT_EQ(picture.width, 4u);
    expectLight(picture, 1, {0.25f, 0.5f, 8, 1});
}

}  // namespace
}  // namespace knuckle::test
