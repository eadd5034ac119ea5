#include <cmath>

#include "sim/base/errors.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 96;

float lightOf(int shown)
{
    const float part = static_cast<float>(shown) / 255.0f;
    return part > 0.04045f ? std::pow((part + 0.055f) / 1.055f, 2.4f) : part / 12.92f;
}

/// A plane that leans by 10 degrees, so that it is not the ground, which fades, straight from `height` above it.
Image plane(FloorLook look, const Vector3f& color, float height)
{
    StillWorld still(0.05f);
    Collider& floor = still.addCollider(ColliderShape::Plane, {0, 0, 0});
    floor.orientation = Eigen::AngleAxisf(0.1745f, Vector3f::UnitX());
    floor.floor = look;
    floor.color = color;
    const Vector3f up = floor.orientation * Vector3f::UnitY();
    RenderSettings settings = lookFrom(height * up + Vector3f(0.3137f, 0, 0), {0.3137f, 0, 0}, SIZE, SIZE);
    settings.toneMap = ToneMap::Linear;
    settings.light.intensity = 0.0f;
    settings.light.skyColor = settings.light.groundColor = {1, 1, 1};
    return drawn(still.world, settings);
}

struct Spread {
    double mean = 0.0, deviation = 0.0;
};

Spread spreadOf(const Image& image)
{
    double sum = 0.0, squares = 0.0;
    for (uint32_t i = 0; i < SIZE * SIZE; ++i) {
        const double light = lightOf(pixelAt(image, i % SIZE, i / SIZE).y());
        sum += light;
        squares += light * light;
    }
    const double count = SIZE * SIZE, mean = sum / count;
    return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

TEST(Floor, FarGridIsItsMeanWithoutMoire)
{
    // Lines of 0.04 of the fine cells' sides and of 0.012 of the coarse ones' in both directions, which take away 0.35
    // and 0.6 of the light. Where both cross they are not independent, which is 0.002 at most.
    const double fine = 1.0 - 0.96 * 0.96, coarse = 1.0 - 0.988 * 0.988;
    const double expected = 0.8 * 0.62 * (1.0 - 0.35 * fine) * (1.0 - 0.6 * coarse);
    // A pixel is 10 m wide, then 1.3 m, then 0.13 m.
    for (const float height : {1000.0f, 130.0f, 13.0f}) {
        const Spread far = spreadOf(plane(FloorLook::Grid, {0.8f, 0.8f, 0.8f}, height));
        // A colour's root has steps of 1/255, and so has what is displayed: 0.004 of the light each.
        EXPECT_NEAR(far.mean, expected, 0.006) << height;
        // Where a pixel holds a few lines, one more or less of them in ten is 0.35 x 0.04 / 10, and the steps.
        if (height > 100.0f) {
            EXPECT_LT(far.deviation, 0.004) << height;
        }
    }
}

TEST(Floor, NearGridHasLinesAndFarLooksHaveNoMoire)
{
    EXPECT_GT(spreadOf(plane(FloorLook::Grid, {0.8f, 0.8f, 0.8f}, 0.5f)).deviation, 0.02);
    for (const FloorLook look : {FloorLook::Tiles, FloorLook::Checker, FloorLook::Wood, FloorLook::Grass}) {
        const Spread near = spreadOf(plane(look, {0.8f, 0.8f, 0.8f}, 2.0f));
        const Spread far = spreadOf(plane(look, {0.8f, 0.8f, 0.8f}, 3000.0f));
        EXPECT_GT(near.deviation, 0.01) << int(look);
        EXPECT_LT(far.deviation, 0.004) << int(look);
    }
}

TEST(Floor, StudioIsPlainAndNoneIsNotThere)
{
    EXPECT_LT(spreadOf(plane(FloorLook::Studio, {0.8f, 0.8f, 0.8f}, 2.0f)).deviation, 1e-3);
    const auto picture = [](FloorLook look, bool visible) {
        StillWorld still(0.05f);
        Collider& floor = still.addCollider(ColliderShape::Plane, {0, 0, 0});
        floor.floor = look;
        floor.visible = visible;
        return drawn(still.world, lookFrom({0, 2, 3}, {0, 0, 0}, SIZE, SIZE)).rgb;
    };
    EXPECT_EQ(picture(FloorLook::None, true), picture(FloorLook::Default, false));
    EXPECT_NE(picture(FloorLook::None, true), picture(FloorLook::Default, true));
}

/// A ball on nothing.
Image ballOn(Background background, uint32_t antialiasing)
{
    StillWorld still(0.05f);
    Collider& ball = still.addCollider(ColliderShape::Sphere, {0, 0, 0});
    ball.radius = 0.5f;
    ball.color = {0.7f, 0.2f, 0.1f};
    RenderSettings settings = lookFrom({0, 0, 3}, {0, 0, 0}, SIZE, SIZE);
    settings.background = background;
    settings.backgroundColor = {0.2f, 0.4f, 0.6f};
    settings.antialiasing = antialiasing;
    return drawn(still.world, settings);
}

TEST(Background, TransparentPicturesHaveAnAlphaWithSoftEdges)
{
    const Image sky = ballOn(Background::Sky, 1);
    EXPECT_TRUE(sky.alpha.empty());
    for (const uint32_t samples : {1u, 2u}) {
        const Image image = ballOn(Background::Transparent, samples);
        ASSERT_EQ(image.alpha.size(), size_t{SIZE} * SIZE);
        const auto alphaAt = [&](uint32_t x, uint32_t y) { return int(image.alpha[size_t{y} * SIZE + x]); };
        EXPECT_EQ(alphaAt(2, 2), 0);
        EXPECT_EQ(alphaAt(SIZE / 2, SIZE / 2), 255);
        // Inside, the picture is that on the sky.
        EXPECT_LE((pixelAt(image, SIZE / 2, SIZE / 2) - pixelAt(ballOn(Background::Sky, samples), SIZE / 2, SIZE / 2))
                      .cwiseAbs()
                      .maxCoeff(),
                  0);
        int between = 0;
        double covered = 0.0;
        for (uint32_t i = 0; i < SIZE * SIZE; ++i) {
            const int alpha = image.alpha[i];
            covered += alpha / 255.0;
            if (alpha == 0 || alpha == 255) continue;
            ++between;
            // Not darkened by nothing: the ball is red.
            if (alpha > 60) {
                EXPECT_GT(image.rgb[3 * i], image.rgb[3 * i + 2]) << alpha;
            }
        }
        // The ball's image: radius tan(asin(0.5 / 3)) of the picture's half height at this angle of view.
        const double radius = 0.5 * SIZE * std::tan(std::asin(0.5 / 3.0)) /
                              std::tan(0.5 * double(RenderSettings().camera.fieldOfView) * 3.14159265 / 180.0);
        EXPECT_GT(between, 1.0 * radius);
        // Its circumference is right within a tenth of a pixel.
        EXPECT_NEAR(covered, 3.14159265 * radius * radius, 0.1 * 2.0 * 3.14159265 * radius + 1.0);
    }
}

TEST(Floor, MirrorShowsWhatStandsOnIt)
{
    const auto picture = [](FloorLook look) {
        StillWorld still(0.05f);
        still.addCollider(ColliderShape::Plane, {0, 0, 0}).floor = look;
        Collider& box = still.addCollider(ColliderShape::Box, {0, 0.5f, 0});
        box.halfExtents = {0.5f, 0.5f, 0.05f};
        box.color = {0.9f, 0.02f, 0.02f};
        RenderSettings settings = lookFrom({0, 0.6f, 4}, {0, 0.3f, 0}, SIZE, SIZE);
        settings.light.direction = {0, 1, 0.2f};  // no shadow in front
        return drawn(still.world, settings);
    };
    // The box's foot, 4 m away and 0.3 m below the middle of what is seen, has its image below it, a quarter of a metre
    // of it here.
    const auto redness = [&](FloorLook look) {
        const Eigen::Vector3i below = pixelAt(picture(look), SIZE / 2, SIZE / 2 + 18);
        return below.x() - below.z();
    };
    EXPECT_GT(redness(FloorLook::Mirror), redness(FloorLook::Studio) + 15);
    const auto beside = [&](FloorLook look) { return pixelAt(picture(look), 4, SIZE / 2 + 18); };
    EXPECT_LT(std::abs(beside(FloorLook::Mirror).x() - beside(FloorLook::Mirror).z()), 40) << "the sky";
}

TEST(Background, SurfacesOfFluidsRefuseToBeTransparent)
{
    StillWorld still(0.05f);
    still.world.fluidSpacing = 0.05f;
    addFluid(still.world, {{0, 1, 0}});
    RenderSettings settings = lookFrom({0, 0, 3}, {0, 0, 0}, SIZE, SIZE);
    settings.background = Background::Transparent;
    EXPECT_THROW(drawn(still.world, settings), InputError);
    settings.markJoints = true;
    StillWorld empty(0.05f);
    EXPECT_THROW(drawn(empty.world, settings), InputError);
}

TEST(Background, ColorIsWhereNothingIs)
{
    const Image image = ballOn(Background::Color, 1);
    // Film's curve: x (6.2 x + 0.5) / (x (6.2 x + 1.7) + 0.06) of what is 0.004 less.
    const Vector3f light(0.2f, 0.4f, 0.6f);
    for (int k = 0; k < 3; ++k) {
        const float x = light[k] - 0.004f, shown = x * (6.2f * x + 0.5f) / (x * (6.2f * x + 1.7f) + 0.06f);
        EXPECT_NEAR(static_cast<float>(pixelAt(image, 2, 2)[k]), 255.0f * shown, 0.6f);
    }
}

}  // namespace
}  // namespace knuckle::test
