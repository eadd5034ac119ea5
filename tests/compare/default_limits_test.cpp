#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/compare/verdict.h"
#include "tests/compare/made_pictures.h"

namespace knuckle::test {
namespace {

/// A disc of a scene, with smooth edges.
struct Disc {
    double x, y, radius;
    std::array<int, 3> color;
};

/// A sky that darkens upwards and discs in front of it, which overlap in their order.
Picture sceneOf(uint32_t width, uint32_t height, const std::vector<Disc>& discs)
{
    return madePicture(width, height, [&](uint32_t x, uint32_t y) {
        const double sky = 200.0 - 100.0 * (height - y) / height;
        std::array<double, 3> color{0.6 * sky, 0.8 * sky, sky};
        for (const Disc& disc : discs) {
            const double distance = std::hypot(x + 0.5 - disc.x, y + 0.5 - disc.y);
            const double covered = std::clamp(disc.radius + 0.5 - distance, 0.0, 1.0);
            for (size_t c = 0; c < 3; ++c) color[c] += covered * (disc.color[c] - color[c]);
        }
        return std::array<int, 3>{static_cast<int>(color[0]), static_cast<int>(color[1]), static_cast<int>(color[2])};
    });
}

/// A heap of particles of 6 pixels.
std::vector<Disc> heap(uint32_t width, uint32_t height)
{
    std::mt19937 random(7);
    std::vector<Disc> discs;
    for (int i = 0; i < 400; ++i) {
        const auto x = static_cast<double>(random() % width),
                   y = height * 0.4 + static_cast<double>(random() % (height / 2));
        discs.push_back({x, y, 3, {static_cast<int>(90 + random() % 90), static_cast<int>(80 + random() % 60), 70}});
    }
    return discs;
}

bool isEqual(const Picture& a, const Picture& b)
{
    const PictureComparison comparison = comparePictures(a, b, {});
    const Verdict verdict = judge(comparison, {});
    testing::Test::RecordProperty("verdict", verdictLine(comparison, verdict));
    return verdict.equal;
}

TEST(DefaultLimits, FindAParticleThatIsGone)
{
    std::vector<Disc> discs = heap(640, 360);
    const Picture a = sceneOf(640, 360, discs);
    for (const size_t gone : {size_t{399}, size_t{380}, size_t{350}}) {
        std::vector<Disc> fewer = discs;
        fewer.erase(fewer.begin() + static_cast<ptrdiff_t>(gone));
        EXPECT_FALSE(isEqual(a, sceneOf(640, 360, fewer))) << gone;
    }
}

TEST(DefaultLimits, FindAnArmThatIsGoneFromASmallPicture)
{
    std::vector<Disc> figure{{80, 30, 8, {190, 120, 90}}, {80, 50, 13, {60, 60, 150}}};
    const std::vector<Disc> body = figure;
    for (int i = 0; i < 6; ++i) figure.push_back({92.0 + 3 * i, 44.0 + i, 2, {190, 120, 90}});
    EXPECT_FALSE(isEqual(sceneOf(160, 90, figure), sceneOf(160, 90, body)));
}

TEST(DefaultLimits, FindAnIconThatIsGone)
{
    const Picture a = sceneOf(1920, 1080, {});
    Picture b = a;
    fillBox(b, 1880, 20, 14, 14, {200, 200, 210});
    EXPECT_FALSE(isEqual(a, b));
}

TEST(DefaultLimits, FindAChangeOfBrightness)
{
    for (const float gain : {1.03f, 0.97f}) {
        const Picture a = sceneOf(640, 360, heap(640, 360));
        Picture b = a;
        for (size_t i = 0; i < b.rgba.size(); ++i)
            if (i % 4 != 3) b.rgba[i] = std::round(b.rgba[i] * gain * 255.0f) / 255.0f;
        EXPECT_FALSE(isEqual(a, b)) << gain;
    }
}

TEST(DefaultLimits, FindHalfTransparency)
{
    const Picture a = sceneOf(320, 180, heap(320, 180));
    for (const bool premultiplied : {true, false}) {
        Picture b = a;
        b.hasAlpha = true;
        for (size_t i = b.rgba.size() / 2; i < b.rgba.size(); ++i)
            if (premultiplied || i % 4 == 3) b.rgba[i] *= 128.0f / 255.0f;
        EXPECT_FALSE(isEqual(a, b));
    }
}

TEST(DefaultLimits, FindFourPixelsOfALargePicture)
{
    const Picture a = sceneOf(3840, 2160, {{1000, 1000, 400, {90, 90, 90}}});
    Picture together = a, apart = a;
    fillBox(together, 1001, 901, 2, 2, {150, 150, 150});
    for (const uint32_t x : {100u, 900u, 2000u, 3839u}) setPixel(apart, x, x / 2, {255, 255, 255});
    EXPECT_FALSE(isEqual(a, together));
    EXPECT_FALSE(isEqual(a, apart));
}

TEST(DefaultLimits, FindAThingThatMovedByOnePixel)
{
    EXPECT_FALSE(
        isEqual(sceneOf(640, 360, {{300, 150, 60, {30, 30, 30}}}), sceneOf(640, 360, {{301, 150, 60, {30, 30, 30}}})));
}

/// How much a pixel differs from the most different of its neighbours.
float contrast(const Picture& picture, uint32_t x, uint32_t y)
{
    const float* pixel = &picture.rgba[(static_cast<size_t>(y) * picture.width + x) * 4];
    return std::max(pixelDifference(pixel, pixel + 4), pixelDifference(pixel, pixel + size_t{4} * picture.width));
}

TEST(DefaultLimits, LetRoundingsPass)
{
    const Picture a = sceneOf(640, 360, heap(640, 360));
    for (const bool everywhere : {false, true}) {
        std::mt19937 random(11);
        Picture b = a;
        for (uint32_t y = 0; y + 1 < a.height; ++y)
            for (uint32_t x = 0; x + 1 < a.width; ++x) {
                if (!everywhere && contrast(a, x, y) < 8.0f) continue;
                for (size_t c = 0; c < 3; ++c)
                    pixelOf(b, x, y)[c] +=
                        (static_cast<float>(random() % (everywhere ? 3 : 5)) - (everywhere ? 1.0f : 2.0f)) / 255.0f;
            }
        EXPECT_TRUE(isEqual(a, b)) << (everywhere ? "1 step everywhere" : "2 steps along edges");
    }
}

TEST(DefaultLimits, LetSingleEdgePixelsPass)
{
    const Picture a = sceneOf(640, 360, heap(640, 360));
    std::mt19937 random(5);
    Picture b = a;
    int changed = 0;
    for (uint32_t y = 1; y + 1 < a.height; ++y)
        for (uint32_t x = 1; x + 1 < a.width; ++x) {
            if (contrast(a, x, y) < 30.0f || random() % 100 != 0) continue;
            // Another coverage: some of the neighbour's colour.
            for (size_t c = 0; c < 3; ++c)
                pixelOf(b, x, y)[c] += 0.5f * (pixelOf(b, x, y)[4 + c] - pixelOf(b, x, y)[c]);
            ++changed;
        }
    EXPECT_GT(changed, 20);
    EXPECT_TRUE(isEqual(a, b));
}

TEST(DefaultLimits, LetMovedEdgesPassWhereTheyAreIgnored)
{
    CompareSettings settings;
    settings.ignoreAntialiasing = true;
    const Picture a = sceneOf(640, 360, {{300, 150, 60.2, {30, 30, 30}}});
    const auto verdict = [&](const std::vector<Disc>& discs) {
        return judge(comparePictures(a, sceneOf(640, 360, discs), settings), {});
    };
    EXPECT_TRUE(verdict({{300.4, 150, 60.2, {30, 30, 30}}}).equal);
    EXPECT_FALSE(verdict({{303, 150, 60.2, {30, 30, 30}}}).equal);
    EXPECT_FALSE(verdict({}).equal);
}

}  // namespace
}  // namespace knuckle::test
