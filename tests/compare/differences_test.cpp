#include "render/compare/differences.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/compare/antialiasing.h"
#include "render/compare/places.h"
#include "render/compare/tiles.h"
#include "tests/compare/made_pictures.h"

namespace knuckle::test {
namespace {

TEST(Differences, AreCountedByChannelAndThreshold)
{
    const Picture a = flatPicture(4, 3, {100, 100, 100});
    Picture b = a;
    setPixel(b, 1, 0, {108, 100, 100});
    setPixel(b, 3, 2, {100, 91, 100});
    const Differences found = findDifferences(a, b, 8.0f, 12, 2);
    EXPECT_EQ(found.differing, 2u);
    EXPECT_EQ(found.changed, 1u) << "8 is not more than 8";
    EXPECT_NEAR(found.channels[0].max, 8, 1e-3);
    EXPECT_NEAR(found.channels[1].mean, 9.0 / 12.0, 1e-5);
    EXPECT_NEAR(found.mean, (8.0 + 9.0) / 12.0 / 3.0, 1e-5);
    EXPECT_NEAR(found.max, 9, 1e-3);
    EXPECT_EQ(found.marks[1], 1);
    EXPECT_EQ(found.marks[11], 2);
}

TEST(Differences, OfTheLastBitCountWhereTheThresholdIsZero)
{
    Picture a = flatPicture(4, 3, {100, 100, 100}), b = a;
    b.rgba[0] = std::nextafter(b.rgba[0], 1.0f);
    EXPECT_EQ(findDifferences(a, b, 0.0f, 12, 1).changed, 1u);
    setPixel(b, 1, 0, {101, 100, 100});
    EXPECT_EQ(findDifferences(a, b, 0.0f, 12, 1).changed, 2u);
    EXPECT_EQ(findDifferences(a, b, 1.0f, 12, 1).changed, 0u);
}

TEST(Differences, OfAlphaCountAsThoseOfAChannel)
{
    Picture a = flatPicture(2, 2, {0, 0, 0}), b = a;
    b.hasAlpha = true;
    pixelOf(b, 0, 0)[3] = 0.5f;
    const Differences found = findDifferences(a, b, 8.0f, 4, 1);
    EXPECT_NEAR(found.channels[3].max, 127.5, 1e-3);
    EXPECT_NEAR(found.mean, 127.5 / 4 / 4, 1e-4);
    EXPECT_EQ(found.changed, 1u);
}

TEST(Differences, OfWhatIsNoNumberAreNoneOrTheLargest)
{
    Picture a = flatPicture(2, 1, {10, 10, 10}), b = a;
    pixelOf(a, 0, 0)[0] = pixelOf(b, 0, 0)[0] = pixelOf(b, 1, 0)[1] = std::numeric_limits<float>::quiet_NaN();
    const Differences found = findDifferences(a, b, 8.0f, 2, 1);
    EXPECT_EQ(found.differing, 1u);
    EXPECT_GT(found.max, 1e30);
    EXPECT_TRUE(std::isfinite(found.max));
}

std::vector<uint8_t> marksOf(uint32_t width, uint32_t height, const std::vector<PixelBox>& boxes)
{
    std::vector<uint8_t> marks(static_cast<size_t>(width) * height);
    for (const PixelBox& box : boxes)
        for (uint32_t y = box.y; y < box.y + box.height; ++y)
            for (uint32_t x = box.x; x < box.x + box.width; ++x) marks[static_cast<size_t>(y) * width + x] = 2;
    return marks;
}

TEST(Places, AreJoinedAcrossSmallGapsAndSortedBySize)
{
    // The first two are four pixels apart, the third is five away from them, the last alone.
    const auto marks = marksOf(100, 60, {{10, 10, 3, 3}, {17, 12, 2, 8}, {24, 12, 2, 2}, {60, 40, 30, 10}});
    const std::vector<DifferencePlace> places = findPlaces(marks, 100, 60, 2);
    ASSERT_EQ(places.size(), 3u);
    EXPECT_EQ(places[0].pixels, 300u);
    EXPECT_EQ(places[0].box.x, 60u);
    EXPECT_EQ(places[1].pixels, 9u + 16u);
    EXPECT_EQ(places[1].box.x, 10u);
    EXPECT_EQ(places[1].box.width, 9u);
    EXPECT_EQ(places[1].box.height, 10u);
    EXPECT_EQ(places[2].pixels, 4u);
    EXPECT_TRUE(findPlaces(marks, 100, 60, 3).empty());
}

TEST(Places, OfOneRowAreJoinedByTheSameGap)
{
    const auto marks = marksOf(40, 1, {{3, 0, 2, 1}, {9, 0, 1, 1}, {15, 0, 1, 1}});
    const std::vector<DifferencePlace> places = findPlaces(marks, 40, 1, 2);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0].box.width, 7u);
    EXPECT_EQ(places[1].box.x, 15u);
}

TEST(Places, OfARingAreOne)
{
    const auto marks = marksOf(50, 50, {{5, 5, 40, 1}, {5, 44, 40, 1}, {5, 5, 1, 40}, {44, 5, 1, 40}});
    const std::vector<DifferencePlace> places = findPlaces(marks, 50, 50, 2);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0].pixels, 4u * 39u);
    EXPECT_EQ(places[0].box.width, 40u);
}

TileDifference worstTile(const Picture& a, const Picture& b)
{
    return findWorstTile(a, b, findDifferences(a, b, 8.0f, a.pixelCount(), 1).marks, 1);
}

TEST(Tiles, ScoreWhatIsGoneByItsPlace)
{
    const Picture a = flatPicture(200, 100, {50, 50, 50});
    Picture b = a;
    fillBox(b, 120, 60, 4, 4, {150, 150, 150});
    const TileDifference tile = worstTile(a, b);
    // In a tile of 8 x 8: 16 of 64 pixels by 100, of which 2 count as rounding.
    EXPECT_NEAR(tile.score, 98.0 * 16 / 64, 1e-3);
    EXPECT_EQ(tile.box.width, 8u);
    EXPECT_LE(tile.box.x, 120u);
    EXPECT_GE(tile.box.x + tile.box.width, 124u);
    EXPECT_EQ(worstTile(a, a).score, 0.0);
}

TEST(Tiles, GrowWithTheRootOfTheirSize)
{
    // 1.5 steps everywhere: 0.5 beyond rounding, times the root of 64 / 8; single pixels differ by rounding only.
    const Picture a = flatPicture(128, 128, {100, 100, 100});
    Picture b = a;
    for (size_t i = 0; i < b.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) b.rgba[i + c] += 1.5f / 255.0f;
    const TileDifference tile = worstTile(a, b);
    EXPECT_NEAR(tile.score, 0.5 * std::sqrt(8.0), 1e-3);
    EXPECT_EQ(tile.box.width, 64u);
}

TEST(Tiles, TakeWhatNeighboursExplainForAnEdge)
{
    // An edge pixel that another driver covers otherwise is between its neighbours; a dot is not.
    const auto edge = [](uint32_t x, uint32_t) { return std::array<int, 3>{x < 20 ? 0 : 200, x < 20 ? 0 : 200, 0}; };
    const Picture a = madePicture(64, 64, edge);
    Picture b = a;
    setPixel(b, 20, 30, {90, 90, 0});
    EXPECT_EQ(worstTile(a, b).score, 0.0);
    b = a;
    setPixel(b, 40, 30, {0, 0, 0});
    EXPECT_NEAR(worstTile(a, b).score, 198.0 * 2 / 3 / 64, 1e-3);
}

/// A disc with smooth edges: the share of 16 x 16 points of each pixel that it covers.
Picture disc(double centre, double radius)
{
    return madePicture(60, 60, [=](uint32_t x, uint32_t y) {
        int covered = 0;
        for (int i = 0; i < 256; ++i) {
            const double u = x + (i % 16 + 0.5) / 16 - centre, v = y + (i / 16 + 0.5) / 16 - 30;
            covered += u * u + v * v < radius * radius ? 1 : 0;
        }
        const int step = 30 + 200 * covered / 256;
        return std::array<int, 3>{step, step, step};
    });
}

uint64_t countEdges(const Picture& a, const Picture& b, uint64_t& changed)
{
    uint64_t edges = 0;
    changed = 0;
    for (uint32_t y = 0; y < a.height; ++y)
        for (uint32_t x = 0; x < a.width; ++x) {
            const size_t at = (static_cast<size_t>(y) * a.width + x) * 4;
            if (pixelDifference(&a.rgba[at], &b.rgba[at]) <= 8.0f) continue;
            ++changed;
            edges += isAntialiasedEdge(a, b, x, y) ? 1 : 0;
        }
    return edges;
}

TEST(Antialiasing, IsToldFromAMoveOfTwoPixels)
{
    uint64_t changed = 0;
    const Picture a = disc(30.0, 15.3);
    uint64_t edges = countEdges(a, disc(30.4, 15.3), changed);
    EXPECT_GT(changed, 40u);
    EXPECT_GE(edges * 10, changed * 9) << "moved by 0.4 pixels";
    edges = countEdges(a, disc(32.5, 15.3), changed);
    EXPECT_LE(edges * 2, changed) << "moved by 2.5 pixels";
    edges = countEdges(a, flatPicture(60, 60, {30, 30, 30}), changed);
    EXPECT_LE(edges * 5, changed) << "gone";
}

TEST(Antialiasing, IsNotWhatIsFlatBesideAnEdge)
{
    // Where three areas meet, of which one has changed: its corner has a darker and a brighter neighbour, too.
    const auto areas = [](int third) {
        return madePicture(40, 40, [third](uint32_t x, uint32_t y) {
            const int step = x < 10 ? 0 : y < 20 ? 200 : third;
            return std::array<int, 3>{step, step, step};
        });
    };
    EXPECT_FALSE(isAntialiasedEdge(areas(100), areas(120), 10, 20));
}

}  // namespace
}  // namespace knuckle::test
