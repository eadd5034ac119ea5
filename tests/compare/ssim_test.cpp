#include "render/compare/ssim.h"

#include <gtest/gtest.h>

#include "render/compare/differences.h"
#include "tests/compare/made_pictures.h"

namespace knuckle::test {
namespace {

SsimResult ssimOf(const Picture& a, const Picture& b, unsigned threads = 1)
{
    return ssim(a, b, findDifferences(a, b, 8.0f, a.pixelCount(), 1).marks, {}, threads);
}

TEST(Ssim, OfFlatPicturesIsThatOfTheirLuma)
{
    // (2 a b + C1) / (a a + b b + C1), for variances are 0. a = 0.4, b = 0.8.
    const double wanted = (2 * 0.4 * 0.8 + 1e-4) / (0.16 + 0.64 + 1e-4);
    const Picture a = flatPicture(30, 20, {102, 102, 102}), b = flatPicture(30, 20, {204, 204, 204});
    EXPECT_NEAR(ssimOf(a, b).mean, wanted, 1e-5);
    EXPECT_NEAR(ssimOf(b, a).worst, wanted, 1e-5);
    EXPECT_EQ(ssimOf(a, a).mean, 1.0);
    EXPECT_NEAR(ssimOf(flatPicture(1, 1, {102, 102, 102}), flatPicture(1, 1, {204, 204, 204})).mean, wanted, 1e-5);
}

TEST(Ssim, OfANegativeIsBelowZeroAndTellsWhere)
{
    const auto board = [](bool turned) {
        return madePicture(80, 60, [turned](uint32_t x, uint32_t y) {
            const bool dark = ((x + y) % 2 == 0) != (turned && x >= 40 && y >= 30);
            return dark ? std::array<int, 3>{20, 20, 20} : std::array<int, 3>{230, 230, 230};
        });
    };
    const SsimResult found = ssimOf(board(false), board(true));
    EXPECT_LT(found.worst, -0.9);
    EXPECT_GE(found.box.x, 40u);
    EXPECT_GE(found.box.y, 30u);
    EXPECT_EQ(found.box.width, 11u);
    // A quarter of the windows is turned, and a part of those that span its border.
    EXPECT_GT(found.mean, 0.2);
    EXPECT_LT(found.mean, 0.75);
    EXPECT_EQ(ssimOf(board(false), board(true), 2).mean, found.mean);
}

}  // namespace
}  // namespace knuckle::test
