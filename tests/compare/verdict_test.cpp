#include "render/compare/verdict.h"

#include <gtest/gtest.h>

#include "render/compare/difference_pictures.h"
#include "tests/compare/made_pictures.h"

namespace knuckle::test {
namespace {

/// A box of 10 x 10 that has become brighter by 60 in a picture of 100 x 100.
PictureComparison boxComparison()
{
    const Picture a = flatPicture(100, 100, {100, 100, 100});
    Picture b = a;
    fillBox(b, 40, 30, 10, 10, {160, 160, 160});
    return comparePictures(a, b, {});
}

TEST(Verdict, NamesEachLimitThatDoesNotHold)
{
    const PictureComparison comparison = boxComparison();
    CompareLimits none{{}, {}, {}, {}, {}, {}, {}};
    EXPECT_TRUE(judge(comparison, none).equal);
    const auto reason = [&](CompareLimits limits) {
        const Verdict verdict = judge(comparison, limits);
        EXPECT_EQ(verdict.equal, verdict.reasons.empty());
        return verdict.reasons.empty() ? "" : verdict.reasons[0];
    };
    CompareLimits limits = none;
    limits.pixels = 99;
    EXPECT_EQ(reason(limits), "100 of 10000 pixels differ by more than 8 of 255 (99 may)");
    limits.pixels = 100;
    EXPECT_EQ(reason(limits), "");
    limits = none;
    limits.share = 0.0099;
    EXPECT_EQ(reason(limits), "100 of 10000 pixels differ by more than 8 of 255 (99 may, 0.99 %)");
    limits.share = 0.01;
    EXPECT_EQ(reason(limits), "");
    limits = none;
    limits.mean = 0.5;
    EXPECT_EQ(reason(limits), "mean difference of 255 0.6 (at most 0.5)");
    limits = none;
    limits.largest = 59.5;
    EXPECT_EQ(reason(limits), "largest difference of 255 60 (at most 59.5)");
    limits = none;
    limits.tile = 1;
    EXPECT_TRUE(reason(limits).starts_with("the tile at 40,28, 8 x 8 scores ") ||
                reason(limits).starts_with("the tile at "))
        << reason(limits);
    limits = none;
    limits.flip = 1e-4;
    EXPECT_TRUE(reason(limits).starts_with("mean FLIP 0.0")) << reason(limits);
    limits = none;
    limits.ssim = 0.999;
    EXPECT_TRUE(reason(limits).starts_with("mean SSIM 0.9")) << reason(limits);
}

TEST(Verdict, OfOtherSizesIsDifferentWhateverTheLimits)
{
    const PictureComparison comparison = comparePictures(flatPicture(640, 360, {0, 0, 0}),
                                                         flatPicture(320, 180, {0, 0, 0}), {});
    const Verdict verdict = judge(comparison, {{}, {}, {}, {}, {}, {}, {}});
    EXPECT_EQ(verdictLine(comparison, verdict), "different: 640 x 360 against 320 x 180");
    EXPECT_EQ(placesLine(comparison), "");
}

TEST(Verdict, SaysWhatIsSmallInNumbersThatAreNotZero)
{
    const Picture a = flatPicture(2000, 1000, {100, 100, 100});
    Picture b = a;
    setPixel(b, 1200, 600, {110, 100, 100});
    CompareSettings settings;
    settings.withSsim = false;
    const PictureComparison comparison = comparePictures(a, b, settings);
    CompareLimits limits;
    EXPECT_TRUE(verdictLine(comparison, judge(comparison, limits))
                    .starts_with("equal: 1 of 2000000 pixels differ, 1 by more than 8 of 255; mean 1.667e-06, "
                                 "largest 10, FLIP "))
        << verdictLine(comparison, judge(comparison, limits));
    limits.pixels = 0;
    EXPECT_EQ(verdictLine(comparison, judge(comparison, limits)),
              "different: 1 of 2000000 pixels differs by more than 8 of 255 (0 may)");
    EXPECT_EQ(placesLine(comparison), "the difference is in 1 place, at 1200,600, 1 x 1");
}

TEST(Verdict, FiguresDoNotDependOnThreads)
{
    const Picture a = madePicture(300, 200, [](uint32_t x, uint32_t y) {
        return std::array<int, 3>{static_cast<int>(x * y % 251), static_cast<int>(x % 200), static_cast<int>(y)};
    });
    Picture b = a;
    fillBox(b, 100, 50, 60, 90, {9, 90, 200});
    CompareSettings one, four;
    one.threads = 1;
    four.threads = 4;
    const PictureComparison p = comparePictures(a, b, one), q = comparePictures(a, b, four);
    EXPECT_EQ(p.differences.mean, q.differences.mean);
    EXPECT_EQ(p.tile.score, q.tile.score);
    EXPECT_EQ(p.flip.errors, q.flip.errors);
    EXPECT_EQ(p.ssim.mean, q.ssim.mean);
}

TEST(DifferencePictures, AreBlackWherePicturesAreEqual)
{
    const Picture a = flatPicture(100, 100, {100, 100, 100});
    Picture b = a;
    fillBox(b, 40, 30, 10, 10, {105, 100, 255});
    const PictureComparison comparison = comparePictures(a, b, {});
    const Image difference = differencePicture(a, b, comparison), heat = heatmapPicture(comparison);
    const size_t inside = (35 * 100 + 45) * 3, outside = 0;
    EXPECT_EQ(difference.rgb[inside], 40);
    EXPECT_EQ(difference.rgb[inside + 1], 0);
    EXPECT_EQ(difference.rgb[inside + 2], 255);
    EXPECT_EQ(difference.rgb[outside], 0);
    EXPECT_EQ(heat.rgb[outside], 0);
    EXPECT_EQ(heat.rgb[outside + 2], 4);
    EXPECT_GT(heat.rgb[inside], 100);
}

TEST(PictureOf, TakesTheRenderersPixels)
{
    const Picture picture = pictureOf(2, 1, {0, 51, 255, 102, 0, 0});
    EXPECT_NEAR(picture.rgba[1], 0.2f, 1e-6f);
    EXPECT_NEAR(picture.rgba[4], 0.4f, 1e-6f);
    EXPECT_EQ(picture.rgba[7], 1.0f);
    EXPECT_FALSE(picture.hasAlpha);
}

}  // namespace
}  // namespace knuckle::test
