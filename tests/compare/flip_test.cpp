#include "render/compare/flip/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/compare/comparison.h"
#include "render/compare/flip/flip_colors.h"
#include "render/compare/flip/flip_filters.h"
#include "tests/compare/made_pictures.h"

namespace knuckle::test {
namespace {

FlipResult flipOf(const Picture& a, const Picture& b, FlipSettings settings = {}, unsigned threads = 1)
{
    const std::vector<uint8_t> marks = findDifferences(a, b, 8.0f, a.pixelCount(), 1).marks;
    return flip(a, b, marks, settings, a.pixelCount(), threads);
}

double sumOf(const std::vector<float>& values)
{
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum;
}

TEST(Flip, OfEqualPicturesIsNothing)
{
    const Picture a = flatPicture(40, 30, {10, 200, 90});
    const FlipResult same = flipOf(a, a);
    EXPECT_EQ(same.mean, 0.0);
    EXPECT_TRUE(same.errors.empty());
}

TEST(Flip, OfFlatPicturesIsTheColorErrorAlone)
{
    // Black and white are 100 apart: 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m), where m = 203.3017^0.7 is the distance of
    // green and blue.
    const double largest = std::pow(203.30165, 0.7);
    const double wanted = 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest);
    EXPECT_NEAR(wanted, 0.967380, 1e-6);
    const Picture black = flatPicture(150, 20, {0, 0, 0}), white = flatPicture(150, 20, {255, 255, 255});
    const FlipResult found = flipOf(black, white);
    EXPECT_NEAR(found.mean, wanted, 1e-5);
    EXPECT_NEAR(found.max, wanted, 1e-5);
    EXPECT_NEAR(flipOf(white, black).mean, wanted, 1e-5) << "either may be the reference";
    EXPECT_NEAR(flipOf(flatPicture(9, 9, {0, 255, 0}), flatPicture(9, 9, {0, 0, 255})).mean, 1.0, 1e-5)
        << "the largest difference there is";
}

TEST(Flip, OfAnEdgeAndADotIsThatOfThePapersFormulas)
{
    // Computed apart from this program in double precision, by kernels of the whole plane. 30 x 30 pixels.
    const Picture black = flatPicture(30, 30, {0, 0, 0});
    Picture edge = black, dot = black;
    fillBox(edge, 15, 0, 15, 30, {255, 255, 255});
    setPixel(dot, 15, 15, {255, 255, 255});
    const FlipResult ofEdge = flipOf(black, edge), ofDot = flipOf(black, dot);
    // Where nearly nothing is left of a filter, the last bit of a float shows.
    EXPECT_NEAR(ofEdge.mean, 0.578607, 1e-4);
    EXPECT_NEAR(ofEdge.errors[15 * 30 + 14], 0.992381, 2e-5);
    EXPECT_NEAR(ofEdge.errors[15 * 30 + 15], 0.993944, 2e-5);
    EXPECT_NEAR(ofDot.mean, 0.0159018, 1e-5);
    EXPECT_NEAR(ofDot.errors[15 * 30 + 15], 0.864906, 2e-5);
    const FlipResult coarse = flipOf(black, dot, {.pixelsPerDegree = 20});
    EXPECT_NEAR(coarse.mean, 0.00323047, 1e-5);
    EXPECT_NEAR(coarse.errors[15 * 30 + 15], 0.989930, 2e-5);
}

TEST(Flip, DoesNotDependOnThreadsOrOnWherePartsMeet)
{
    // Wider than two of the parts of 128 pixels that are worked on at a time: what lies on either side of their border,
    // or on both, is as elsewhere.
    const Picture a = flatPicture(300, 140, {90, 60, 30});
    for (const uint32_t place : {124u, 126u, 128u}) {
        Picture b = a;
        for (const uint32_t x : {30u, place}) fillBox(b, x, 60, 4, 4, {200, 60, 200});
        const FlipResult one = flipOf(a, b), two = flipOf(a, b, {}, 2);
        EXPECT_EQ(one.errors, two.errors);
        EXPECT_EQ(one.mean, two.mean);
        for (uint32_t y = 40; y < 90; ++y)
            for (int x = -20; x < 20; ++x) {
                const auto at = [&](uint32_t box) {
                    return one.errors[y * 300 + static_cast<uint32_t>(static_cast<int>(box) + x)];
                };
                ASSERT_FLOAT_EQ(at(30), at(place)) << place << ": " << x << "," << y;
            }
    }
}

TEST(FlipFilters, HaveTheSumsThatTheyAreDefinedBy)
{
    const FlipFilters filters = makeFlipFilters(DEFAULT_PIXELS_PER_DEGREE);
    EXPECT_EQ(filters.reach, 10u);
    EXPECT_EQ(filters.blueYellow.size(), 21u);
    EXPECT_EQ(filters.edge.size(), 19u);  // 3 * 0.041 * 67.02 = 8.2
    for (const auto* kernel : {&filters.brightness, &filters.redGreen, &filters.blueYellow, &filters.smooth})
        EXPECT_NEAR(sumOf(*kernel), 1.0, 1e-6);
    EXPECT_NEAR(filters.blueYellowWeight + filters.blueYellowNarrowWeight, 1.0f, 1e-6f);
    for (const auto* kernel : {&filters.edge, &filters.point}) {
        double positive = 0.0;
        for (const float weight : *kernel) positive += std::max(0.0, static_cast<double>(weight));
        EXPECT_NEAR(positive, 1.0, 1e-6);
        EXPECT_NEAR(sumOf(*kernel), 0.0, 1e-6);
    }
}

TEST(FlipColors, HaveTheWhiteOfTheirMatrixAndGoBack)
{
    EXPECT_NEAR(WHITE[0], 0.950428545, 1e-8);
    EXPECT_NEAR(WHITE[1], 1.0, 1e-12);
    EXPECT_NEAR(WHITE[2], 1.088900371, 1e-8);
    const Color back = rgbOfOpponent(opponentOfRgb({0.1f, 0.7f, 0.4f}));
    EXPECT_NEAR(back[0], 0.1f, 1e-5f);
    EXPECT_NEAR(back[1], 0.7f, 1e-5f);
    EXPECT_NEAR(back[2], 0.4f, 1e-5f);
    for (const float x : {1e-5f, 0.009f, 0.3f, 1.0f, 1.1f}) EXPECT_NEAR(cubeRoot(x), std::cbrt(x), 2e-7f);
}

/// Light of 0.05 to 16, as linear values.
Picture hdrPattern(float gain)
{
    Picture picture;
    picture.width = 32;
    picture.height = 24;
    picture.hdr = true;
    for (uint32_t y = 0; y < 24; ++y)
        for (uint32_t x = 0; x < 32; ++x) {
            const float here = x >= 8 && x < 16 && y >= 8 && y < 16 ? gain : 1.0f;
            const auto power = static_cast<float>((x + y) % 9) - 4.0f;
            for (const float light :
                 {0.05f * static_cast<float>(1 + x), 0.1f * static_cast<float>(1 + x * y % 7), std::exp2(power)})
                picture.rgba.push_back(encodeSrgb(here * light));
            picture.rgba.push_back(1.0f);
        }
    return picture;
}

TEST(HdrFlip, TakesTheWorstOfTheExposuresOfTheReference)
{
    // As above, computed apart.
    const Picture a = hdrPattern(1.0f), b = hdrPattern(1.5f);
    const Exposures exposures = exposuresOf(a);
    EXPECT_NEAR(exposures.start, 0.101634, 1e-4);
    EXPECT_NEAR(exposures.stop, 1.865421, 1e-4);
    EXPECT_EQ(exposures.count, 2u);
    const FlipResult found = flipOf(a, b);
    EXPECT_NEAR(found.mean, 0.0515538, 2e-5);
    EXPECT_NEAR(found.max, 0.429039, 1e-4);
}

TEST(HdrFlip, BearsDarknessAndWhatIsNoNumber)
{
    Picture black = flatPicture(16, 16, {0, 0, 0});
    black.hdr = true;
    EXPECT_EQ(exposuresOf(black).count, 1u);
    Picture light = black;
    fillBox(light, 4, 4, 3, 3, {255, 255, 255});
    EXPECT_GT(flipOf(black, light).mean, 0.01);
    EXPECT_GT(flipOf(light, black).mean, 0.01) << "more than half of the reference is black";
    pixelOf(light, 0, 0)[0] = std::numeric_limits<float>::infinity();
    pixelOf(light, 9, 9)[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isfinite(flipOf(black, light).mean));
    EXPECT_TRUE(std::isfinite(flipOf(light, black).mean));
    EXPECT_EQ(toneMapAces(std::numeric_limits<float>::infinity()), 1.0f);
}

TEST(Flip, SeesTransparencyOnItsBackground)
{
    Picture clear = flatPicture(20, 20, {0, 0, 0}), white = flatPicture(20, 20, {255, 255, 255});
    for (size_t i = 3; i < clear.rgba.size(); i += 4) clear.rgba[i] = 0.0f;
    EXPECT_GT(flipOf(clear, white).mean, 0.9);
    EXPECT_EQ(flipOf(clear, white, {.background = {1, 1, 1}}).mean, 0.0);
}

}  // namespace
}  // namespace knuckle::test
