#include "render/output/deep_pictures.h"

#include <cmath>
#include <set>

#include "render/reader/picture_file.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// Every 16th value of 16 bits, in three channels.
Image ramp(bool transparent)
{
    Image image{64, 64, std::vector<uint8_t>(3 * 4096)};
    for (uint32_t k = 0; k < 3 * 4096; ++k) image.deep.push_back(static_cast<uint16_t>((16 * k + k / 4096) % 65536));
    if (transparent)
        for (uint32_t k = 0; k < 4096; ++k) image.alpha.push_back(static_cast<uint8_t>(k % 255 + 1));
    image.text = {{"scene", "ramp, ä"}};
    return image;
}

TEST(DeepPictures, PngKeepsEveryBit)
{
    for (const bool transparent : {false, true}) {
        const Image image = ramp(transparent);
        const Picture read = decodePicture(deepPngOf(image), "ramp.png");
        ASSERT_EQ(read.bitDepth, 16u);
        ASSERT_EQ(read.hasAlpha, transparent);
        EXPECT_EQ(read.text.at("scene"), "ramp, ä");
        for (size_t i = 0; i < 4096; ++i)
            for (size_t c = 0; c < 3; ++c) {
                const double alpha = transparent ? image.alpha[i] / 255.0 : 1.0;
                // Floats have 24 bits.
                EXPECT_NEAR(read.rgba[4 * i + c], alpha * image.deep[3 * i + c] / 65535.0, 2e-7) << i;
            }
    }
}

TEST(DeepPictures, ExrKeepsLightToHalfPrecision)
{
    for (const bool transparent : {false, true}) {
        const Image image = ramp(transparent);
        const Picture read = decodePicture(exrOf(image), "ramp.exr");
        ASSERT_EQ(read.hasAlpha, transparent);
        ASSERT_TRUE(read.hdr);
        for (size_t i = 0; i < 4096; ++i)
            for (size_t c = 0; c < 3; ++c) {
                const double alpha = transparent ? image.alpha[i] / 255.0 : 1.0;
                const double light = alpha * decodeSrgb(float(image.deep[3 * i + c]) / 65535.0f);
                // A half has 11 bits, and no less than 2^-24.
                EXPECT_NEAR(decodeSrgb(read.rgba[4 * i + c]), light, light / 2048.0 + 1.0 / 16777216.0 + 1e-7) << i;
            }
    }
}

/// A ball in a soft light has more than 256 shades in 16 bits; in 8 bits they are the same to half a level, apart from
/// edges, whose filter sees other roundings.
TEST(DeepPictures, ADeepFrameHasMoreShadesAndIsTheSamePicture)
{
    StillWorld still(0.5f);
    still.addBody({{0, 0, 0}}, {0, 0, 0});
    RenderSettings settings = lookFrom({0, 0, 2}, {0, 0, 0}, 128, 128);
    settings.colorBy = ColorBy::Material;
    const Image shallow = drawn(still.world, settings);
    settings.depth = 16;
    const Image deep = drawn(still.world, settings);
    EXPECT_TRUE(shallow.deep.empty());
    ASSERT_EQ(deep.deep.size(), shallow.rgb.size());
    EXPECT_GT(std::set<uint16_t>(deep.deep.begin(), deep.deep.end()).size(), 400u);
    size_t apart = 0;
    for (size_t k = 0; k < deep.deep.size(); ++k) {
        if (std::abs(deep.deep[k] / 257.0 - shallow.rgb[k]) > 0.51) ++apart;
        EXPECT_LE(std::abs(int(deep.rgb[k]) - int(std::lround(deep.deep[k] / 257.0))), 0) << k;
    }
    EXPECT_LT(apart, deep.deep.size() / 50);
}

}  // namespace
}  // namespace knuckle::test
