#include <gtest/gtest.h>

#include "render/compare/verdict.h"
#include "sim/base/errors.h"
#include "tests/compare/made_pictures.h"
#include "tests/message_of.h"

namespace knuckle::test {
namespace {

/// A flat picture, and one with a box of 10 x 10 at 20,10 in it.
class Ignored : public testing::Test {
protected:
    Ignored() : a(flatPicture(64, 40, {80, 80, 80})), b(a) { fillBox(b, 20, 10, 10, 10, {200, 30, 30}); }

    PictureComparison compared() const { return comparePictures(a, b, settings); }

    Picture a, b;
    CompareSettings settings;
};

TEST_F(Ignored, RectanglesAreSeenByNoMetric)
{
    settings.ignored.boxes = {{20, 10, 10, 5}};
    EXPECT_EQ(compared().differences.changed, 50u);
    settings.ignored.boxes.push_back({0, 15, 4000000000u, 4000000000u});
    const PictureComparison found = compared();
    EXPECT_TRUE(found.identical());
    EXPECT_EQ(found.compared, 64u * 15u - 50u);
    EXPECT_EQ(found.flip.mean, 0.0);
    EXPECT_EQ(found.ssim.mean, 1.0);
    EXPECT_EQ(found.tile.score, 0.0);
}

TEST_F(Ignored, WhatIsBlackOrClearInAMaskIsNotCompared)
{
    Picture mask = flatPicture(64, 40, {255, 255, 255});
    fillBox(mask, 20, 10, 10, 5, {0, 0, 0});
    for (uint32_t y = 15; y < 20; ++y)
        for (uint32_t x = 20; x < 30; ++x) std::fill_n(pixelOf(mask, x, y), 4, 0.0f);
    settings.ignored.mask = std::make_shared<const Picture>(mask);
    EXPECT_TRUE(compared().identical());
    settings.ignored.mask = std::make_shared<const Picture>(flatPicture(64, 41, {255, 255, 255}));
    EXPECT_EQ(messageOf<InputError>([&] { compared(); }),
              "the mask has 64 x 41 pixels, the images 64 x 40; make it as large as they are");
}

TEST_F(Ignored, ColorsCountInEitherPicture)
{
    settings.ignored.colors = {{200, 30, 30}};
    EXPECT_TRUE(compared().identical());
    std::swap(a, b);
    EXPECT_TRUE(compared().identical());
    settings.ignored.colors = {{201, 30, 30}};
    EXPECT_EQ(compared().differences.changed, 100u);
}

TEST_F(Ignored, SomethingMustBeLeft)
{
    settings.ignored.boxes = {{0, 0, 64, 40}};
    EXPECT_EQ(messageOf<InputError>([&] { compared(); }),
              "nothing is left to compare: all pixels are ignored; ignore less");
}

TEST_F(Ignored, MeansAreOverWhatIsCompared)
{
    settings.ignored.boxes = {{32, 0, 32, 40}};
    EXPECT_NEAR(compared().differences.channels[0].mean, 120.0 * 100 / (32 * 40), 1e-3);
}

}  // namespace
}  // namespace knuckle::test
