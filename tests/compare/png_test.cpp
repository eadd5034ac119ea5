#include <gtest/gtest.h>

#include <cmath>

#include "render/reader/picture_file.h"
#include "tests/compare/made_files.h"

namespace knuckle::test {
namespace {

/// Steps of 255 of the channels of a pixel.
std::array<float, 4> stepsAt(const Picture& picture, uint32_t x, uint32_t y)
{
    std::array<float, 4> steps{};
    for (size_t c = 0; c < 4; ++c)
        steps[c] = 255.0f * picture.rgba[(static_cast<size_t>(y) * picture.width + x) * 4 + c];
    return steps;
}

void expectSteps(const std::array<float, 4>& found, const std::array<float, 4>& wanted)
{
    for (size_t c = 0; c < 4; ++c) EXPECT_NEAR(found[c], wanted[c], 1e-3f) << "channel " << c;
}

TEST(ReadPng, KeepsRgbWithAndWithoutInterlacing)
{
    PngMade made = anyRgb(13, 9);
    for (const bool interlaced : {false, true}) {
        made.interlaced = interlaced;
        const Picture picture = decodePicture(pngBytes(made), "a.png");
        EXPECT_EQ(picture.width, 13u);
        EXPECT_EQ(picture.height, 9u);
        EXPECT_EQ(picture.bitDepth, 8u);
        EXPECT_FALSE(picture.hasAlpha);
        for (uint32_t y = 0; y < 9; ++y)
            for (uint32_t x = 0; x < 13; ++x) {
                const uint8_t* wanted = &made.rows[y][3 * size_t{x}];
                expectSteps(stepsAt(picture, x, y), {static_cast<float>(wanted[0]), static_cast<float>(wanted[1]),
                                                     static_cast<float>(wanted[2]), 255});
            }
    }
}

TEST(ReadPng, KeepsSixteenBits)
{
    PngMade made;
    made.bits = 16;
    made.rows = {{0x12, 0x34, 0x80, 0x01, 0xff, 0xff}};
    const Picture picture = decodePicture(pngBytes(made), "a.png");
    EXPECT_EQ(picture.bitDepth, 16u);
    expectSteps(stepsAt(picture, 0, 0), {255.0f * 0x1234 / 65535.0f, 255.0f * 0x8001 / 65535.0f, 255, 255});
}

TEST(ReadPng, SpreadsGreyOfFewBits)
{
    // Two pixels, the darkest but one and white.
    const struct {
        int bits;
        uint8_t row;
        float first;
    } cases[] = {{1, 0x40, 0}, {2, 0x70, 85}, {4, 0x1f, 17}};
    for (const auto& entry : cases) {
        PngMade made;
        made.width = 2;
        made.bits = entry.bits;
        made.type = 0;
        made.rows = {{entry.row}};
        const Picture picture = decodePicture(pngBytes(made), "a.png");
        EXPECT_EQ(picture.bitDepth, static_cast<uint32_t>(entry.bits));
        expectSteps(stepsAt(picture, 0, 0), {entry.first, entry.first, entry.first, 255});
        expectSteps(stepsAt(picture, 1, 0), {255, 255, 255, 255});
    }
}

TEST(ReadPng, LooksUpPalettesAndTheirAlpha)
{
    PngMade made;
    made.width = 3;
    made.type = 3;
    made.palette = {{10, 20, 30}, {200, 100, 50}, {250, 240, 230}};
    made.paletteAlpha = {255, 51};
    made.rows = {{0, 1, 2}};
    const Picture picture = decodePicture(pngBytes(made), "a.png");
    EXPECT_TRUE(picture.hasAlpha);
    expectSteps(stepsAt(picture, 0, 0), {10, 20, 30, 255});
    expectSteps(stepsAt(picture, 1, 0), {40, 20, 10, 51});  // multiplied by alpha, 0.2
    expectSteps(stepsAt(picture, 2, 0), {250, 240, 230, 255});
}

TEST(ReadPng, TakesGreyWithAlphaAndAClearGrey)
{
    PngMade made;
    made.width = 2;
    made.type = 4;
    made.rows = {{100, 255, 100, 0}};
    Picture picture = decodePicture(pngBytes(made), "a.png");
    expectSteps(stepsAt(picture, 0, 0), {100, 100, 100, 255});
    expectSteps(stepsAt(picture, 1, 0), {0, 0, 0, 0});
    made.type = 0;
    made.rows = {{100, 101}};
    made.clearGrey = 101;
    picture = decodePicture(pngBytes(made), "a.png");
    EXPECT_TRUE(picture.hasAlpha);
    expectSteps(stepsAt(picture, 0, 0), {100, 100, 100, 255});
    expectSteps(stepsAt(picture, 1, 0), {0, 0, 0, 0});
}

TEST(ReadPng, TurnsGammaIntoSrgbUnlessTheFileSaysSrgb)
{
    PngMade made;
    made.type = 0;
    made.rows = {{55}};
    const auto grey = [&made] { return stepsAt(decodePicture(pngBytes(made), "a.png"), 0, 0)[0]; };
    EXPECT_NEAR(grey(), 55, 1e-3);
    made.gamma = 1.0;  // linear light: 0.2157 is 0.5018 in sRGB
    EXPECT_NEAR(grey() / 255.0, 1.055 * std::pow(55.0 / 255.0, 1.0 / 2.4) - 0.055, 1e-5);
    made.gamma = 0.45455;
    EXPECT_NEAR(grey(), 55, 1e-3) << "what files say that mean sRGB";
    made.gamma = 1.0;
    made.srgb = true;
    EXPECT_NEAR(grey(), 55, 1e-3);
}

TEST(ReadPng, HasItsTextByKeyword)
{
    PngMade made = anyRgb(1, 1);
    made.latinText = {{"Software", "Knuckle 1"}, {"Author", "J\xf6rg"}};
    made.unicodeText = {{"knuckle:scene", "H\xc3\xbcpfer"}};
    const Picture picture = decodePicture(pngBytes(made), "a.png");
    const std::map<std::string, std::string> wanted{
        {"Author", "J\xc3\xb6rg"}, {"Software", "Knuckle 1"}, {"knuckle:scene", "H\xc3\xbcpfer"}};
    EXPECT_EQ(picture.text, wanted);
}

}  // namespace
}  // namespace knuckle::test
