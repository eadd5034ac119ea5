#include <cmath>
#include <numbers>

#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.04f;
constexpr uint32_t SIZE = 240;

/// A cube of fluid of 1.2 m in the air, whose upper surface is at 0.
World cube(float absorption)
{
    StillWorld still(0.04f);
    World& world = still.world;
    world.fluidSpacing = SPACING;
    world.materials[0].look = {DrawnAs::Surface, absorption, 0.0f};
    world.materials[0].color = {0.2f, 0.5f, 0.8f};
    std::vector<Vector3f> places;
    for (int z = -15; z < 15; ++z)
        for (int y = -30; y < 0; ++y)
            for (int x = -15; x < 15; ++x)
                places.push_back(SPACING * (Vector3f(float(x), float(y), float(z)).array() + 0.5f).matrix());
    addFluid(world, places);
    return world;
}

RenderSettings lookUp(float depth)
{
    RenderSettings settings = lookFrom({0, -depth, 0}, {0, 0, 0.001f}, SIZE, SIZE);
    settings.camera.fieldOfView = 120.0f;
    settings.colorBy = ColorBy::Material;
    settings.toneMap = ToneMap::Linear;
    settings.light.intensity = 0.0f;
    settings.light.skyColor = {1, 1, 1};
    settings.light.groundColor = {0, 0, 0};
    return settings;
}

double lightOf(int shown)
{
    return std::pow(shown / 255.0, 2.2);
}

TEST(Underwater, TheSkyIsSeenThroughSnellsWindow)
{
    // Rays nearer to the surface than asin(1 / 1.333) = 48.6 degrees from the vertical are thrown back, at any depth.
    const double focal = 0.5 * SIZE / std::tan(60.0 * std::numbers::pi / 180.0);
    const double radius = focal * std::tan(std::asin(1.0 / 1.333));
    for (const float depth : {0.2f, 0.35f}) {
        const Image image = drawn(cube(0.0f), lookUp(depth));
        int bright = 0;
        for (uint32_t y = 0; y < SIZE; ++y)
            for (uint32_t x = 0; x < SIZE; ++x)
                // Beyond that rays leave by the cube's sides.
                if (std::hypot(x + 0.5 - 0.5 * SIZE, y + 0.5 - 0.5 * SIZE) < 1.2 * radius)
                    bright += lightOf(pixelAt(image, x, y).y()) > 0.15;
        // The sky is at least 0.3 there; a degree before the window's edge the surface throws a third of it back.
        EXPECT_NEAR(std::sqrt(bright / std::numbers::pi), radius, 0.02 * radius) << depth;
    }
}

TEST(Underwater, FluidBeforeTheCameraDimsWhatIsBehind)
{
    // Beer and Lambert: the colour is what is left of white light after 1 / absorption.
    const Image clear = drawn(cube(0.0f), lookUp(0.4f)), blue = drawn(cube(1.5f), lookUp(0.4f));
    const double left = std::pow(0.2, 1.5 * 0.4);
    const double ratio = lightOf(pixelAt(blue, SIZE / 2, SIZE / 2).x()) /
                         lightOf(pixelAt(clear, SIZE / 2, SIZE / 2).x());
    EXPECT_NEAR(ratio, left, 0.03 * left);
}

/// Below the line where they meet the sky is seen through a side, above it the surface throws back what is dark.
TEST(Underwater, TheSurfaceMeetsASideInALine)
{
    RenderSettings settings = lookUp(0.3f);
    settings.camera.target = {0.6f, 0, 0};
    settings.camera.fieldOfView = 24.0f;
    const Image image = drawn(cube(0.0f), settings);
    const auto isSky = [&](uint32_t x, uint32_t y) { return lightOf(pixelAt(image, x, y).y()) > 0.15; };
    for (uint32_t x = 1; x < SIZE; ++x) {
        uint32_t changes = 0;
        for (uint32_t y = 1; y < SIZE; ++y) changes += isSky(x, y) != isSky(x, y - 1);
        EXPECT_EQ(changes, 1u) << x;
        EXPECT_FALSE(isSky(x, 0)) << x;
    }
}

TEST(Underwater, ACameraAboveTheSurfaceIsNotInFluid)
{
    // A quarter of a spacing above black fluid: it mirrors 0.02 of the sky, which is 0.6 of its blue above.
    RenderSettings settings = lookUp(-0.25f * SPACING);
    settings.camera.target = {0, -1, 0.001f};
    const Image image = drawn(cube(1000.0f), settings);
    EXPECT_NEAR(lightOf(pixelAt(image, SIZE / 2, SIZE / 2).z()), 0.02 * 0.6, 0.003);
}

}  // namespace
}  // namespace knuckle::test
