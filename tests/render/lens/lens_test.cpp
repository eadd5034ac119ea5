#include <numbers>

#include "sim/base/errors.h"
#include "tests/render/lens/lens_scene.h"

namespace knuckle::test {
namespace {

TEST(Lens, AMovingBallIsAStreakAsLongAsItsWay)
{
    constexpr float RADIUS = 0.05f, WAY = 0.6f, DISTANCE = 3.0f;
    constexpr uint32_t DRAWS = 64;
    RenderSettings settings = evenly({0, 0, DISTANCE});
    settings.samples = DRAWS;
    const Spread still = spreadOf(drawn(ball({0, 0, 0}, RADIUS).world, settings));
    settings.shutter = 180.0f;
    const StillWorld first = ball({0, 0, 0}, RADIUS);
    Renderer renderer(sharedGpu(), first.world, settings);
    for (uint32_t k = 0; k < DRAWS; ++k) {
        const StillWorld there = ball({WAY * (float(k) / (DRAWS - 1) - 0.5f), 0, 0}, RADIUS);
        const StillBuffers buffers(there.world);
        renderer.expose(buffers.view(), 0.0, k);
    }
    const Image image = renderer.readImage();
    const Spread streak = spreadOf(image);
    // Light of 1 / 64 is displayed by steps of 3 %, rounded either way; hundreds of pixels even out to far below 1 %.
    EXPECT_NEAR(streak.sum / still.sum, 1.0, 0.01);
    // The places are a lattice of DRAWS points over the way: its mean square is way^2 / 12 (n + 1) / (n - 1).
    const double pixels = WAY / DISTANCE * SIZE / (2.0 * std::tan(std::numbers::pi / 9.0));
    const double way = std::sqrt(12.0 * (streak.square - still.square) * (DRAWS - 1) / (DRAWS + 1));
    EXPECT_NEAR(way, pixels, 1.0);
}

TEST(Lens, WhatIsNotSharpIsADiscOfTheThinLens)
{
    constexpr float RADIUS = 0.02f, APERTURE = 0.3f, SHARP = 2.0f;
    for (const float distance : {1.4f, 2.0f, 4.0f}) {
        const StillWorld still = ball({0, 0, -distance}, RADIUS);
        RenderSettings settings = evenly({0, 0, 0}, {0, 0, -1});
        settings.samples = 64;
        const Spread pinhole = spreadOf(drawn(still.world, settings));
        settings.camera.aperture = APERTURE;
        settings.camera.focus = SHARP;
        const Spread blurred = spreadOf(drawn(still.world, settings));
        const double pixels = SIZE / (2.0 * std::tan(std::numbers::pi / 9.0));
        const double circle = APERTURE * std::abs(distance - SHARP) / distance / SHARP * pixels;
        if (distance == SHARP) {
            // The ball's front is its radius before the plane: 0.03 pixels.
            EXPECT_NEAR(blurred.square, pinhole.square, 0.02 * pinhole.square + 0.01);
            continue;
        }
        // A disc's mean square is an eighth of its diameter's, that of the places on the lens as well.
        EXPECT_NEAR(std::sqrt(8.0 * (blurred.square - pinhole.square)), circle, 0.05 * circle) << distance;
    }
}

TEST(Lens, FocusIsOnWhatTheCameraLooksAtWhereNothingElseIsSaid)
{
    const StillWorld still = ball({0, 0, -3}, 0.02f);
    RenderSettings settings = evenly({0, 0, 0}, {0, 0, -3});
    settings.camera.aperture = 0.3f;
    const Image looked = drawn(still.world, settings);
    settings.camera.focus = 3.0f;
    EXPECT_EQ(looked.rgb, drawn(still.world, settings).rgb);
    settings.camera.focus = 2.0f;
    EXPECT_NE(looked.rgb, drawn(still.world, settings).rgb);
}

TEST(Lens, FocusFollowsNamedParticles)
{
    StillWorld still = ball({0, 0, -3}, 0.02f);
    still.addBody({Vector3f(-0.1f, 0, 0), Vector3f(0.1f, 0, 0)}, {5, 0, -2});
    RenderSettings settings = evenly({0, 0, 0}, {0, 0, -3});
    settings.camera.aperture = 0.3f;
    settings.camera.focus = 2.0f;
    const Image image = drawn(still.world, settings);
    settings.camera.focus = 0.0f;
    EXPECT_NE(drawn(still.world, settings).rgb, image.rgb);
    settings.camera.focused = {{0, 2}};
    EXPECT_EQ(drawn(still.world, settings).rgb, image.rgb);
}

TEST(Lens, DrawsBesideEachOtherCoverAnEdgesPixels)
{
    constexpr double DEGREES = 5.0;
    constexpr uint32_t DRAWS = 8;
    StillWorld still(0.05f);
    Collider& box = still.addCollider(ColliderShape::Box, {-5, 0, -1});
    box.halfExtents = {5, 5, 1};
    box.color = {1, 1, 1};
    RenderSettings settings = evenly({0, 0, 3});
    settings.camera.roll = DEGREES;
    settings.samples = DRAWS;
    const Image image = drawn(still.world, settings);
    const double full = lightOf(static_cast<uint8_t>(pixelAt(image, 4, SIZE / 2).y()));
    const double c = std::cos(DEGREES * std::numbers::pi / 180.0), s = std::sin(DEGREES * std::numbers::pi / 180.0);
    double worst = 0.0;
    for (uint32_t y = SIZE / 4; y < 3 * SIZE / 4; ++y)
        for (uint32_t x = SIZE / 4; x < 3 * SIZE / 4; ++x) {
            constexpr int FINE = 32;
            int inside = 0;
            for (int k = 0; k < FINE * FINE; ++k) {
                const double px = x + (k % FINE + 0.5) / FINE - SIZE / 2.0,
                             py = y + (k / FINE + 0.5) / FINE - SIZE / 2.0;
                inside += c * px + s * py < 0.0;
            }
            const double share = lightOf(static_cast<uint8_t>(pixelAt(image, x, y).y())) / full;
            worst = std::max(worst, std::abs(share - double(inside) / (FINE * FINE)));
        }
    EXPECT_LT(worst, 1.0 / DRAWS);
}

TEST(Lens, RefusesOneDrawOfWhatIsBlurred)
{
    RenderSettings settings;
    settings.samples = 1;
    checkSettings(settings);
    settings.shutter = 90.0f;
    EXPECT_THROW(checkSettings(settings), InputError);
    settings.shutter = 0.0f;
    settings.camera.aperture = 0.1f;
    EXPECT_THROW(checkSettings(settings), InputError);
    settings.samples = 0;
    checkSettings(settings);
    EXPECT_EQ(drawsOf(settings), 16u);
}

}  // namespace
}  // namespace knuckle::test
