#include <cmath>

#include "render/looks/finishes.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 128;

/// Everything around sends `light`.
std::shared_ptr<const SkyMap> uniformSky(float light)
{
    return std::make_shared<const SkyMap>(SkyMap{8, 4, std::vector<Vector3f>(32, Vector3f::Constant(light))});
}

/// A ball of radius 1 m in the middle, of a collider's colour and finish.
World ballOf(const Vector3f& color, const SurfaceFinish& finish)
{
    StillWorld still(0.05f);
    Collider& ball = still.addCollider(ColliderShape::Sphere, {0, 0, 0});
    ball.radius = 1.0f;
    ball.color = color;
    ball.finish = finish;
    return still.world;
}

/// From the front at 8 m; the ball fills most of the picture. Colours are sRGB of the light.
RenderSettings frontOf(float sky)
{
    RenderSettings settings = lookFrom({0, 0, 8}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = 16.0f;
    settings.toneMap = ToneMap::Linear;
    settings.light.intensity = 0.0f;
    settings.light.softness = 0.0f;
    settings.light.sky = uniformSky(sky);
    settings.light.skyColor = settings.light.groundColor = Vector3f::Constant(sky);
    return settings;
}

float lightOf(uint8_t shown)
{
    const float part = static_cast<float>(shown) / 255.0f;
    return part > 0.04045f ? std::pow((part + 0.055f) / 1.055f, 2.4f) : part / 12.92f;
}

float lightAt(const Image& image, uint32_t x, uint32_t y)
{
    return lightOf(static_cast<uint8_t>(pixelAt(image, x, y).y()));
}

TEST(Finish, WhiteMetalUnderAnEvenSkyIsAsBrightAsThat)
{
    for (const float roughness : {0.05f, 0.3f, 0.6f, 1.0f}) {
        const World world = ballOf({1, 1, 1}, {Finish::Metal, roughness, -1.0f});
        const Image image = drawn(world, frontOf(0.5f));
        for (const uint32_t x : {SIZE / 2, SIZE / 2 + 30, SIZE / 2 + 48}) {
            // All that arrives comes back, but for the shade's steps of 1/127 and the picture's of 1/255, which is
            // 1 % of this light.
            EXPECT_LE(lightAt(image, x, SIZE / 2) / 0.5f, 1.015f) << roughness << " at " << x;
            EXPECT_GE(lightAt(image, x, SIZE / 2) / 0.5f, 0.97f) << roughness << " at " << x;
        }
    }
}

TEST(Finish, MirrorsWhatFresnelSaysStraightOn)
{
    // Nothing but what is mirrored comes from a black ball: 0.04 of the sky, which the fit of the lobe's mean knows
    // within 0.006 (Karis 2014).
    const Image black = drawn(ballOf({0, 0, 0}, {Finish::Plastic, 0.02f, -1.0f}), frontOf(10.0f));
    EXPECT_NEAR(lightAt(black, SIZE / 2, SIZE / 2) / 10.0f, 0.04f, 0.007f);
    // Towards the rim more, up to all of it.
    EXPECT_GT(lightAt(black, SIZE / 2 + 56, SIZE / 2), 2.0f * lightAt(black, SIZE / 2, SIZE / 2));
    // Of metal, its colour; of that twice the colour's step of 1/127 and the picture's of 1/255.
    const Image copper = drawn(ballOf({0.9f, 0.45f, 0.3f}, {Finish::Metal, 0.02f, -1.0f}), frontOf(0.8f));
    const Vector3f expected(0.9f, 0.45f, 0.3f);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(lightOf(static_cast<uint8_t>(pixelAt(copper, SIZE / 2, SIZE / 2)[k])) / 0.8f, expected[k], 0.025f);
}

/// The point of the unit ball whose normal is half-way between the light and the eye.
Vector3f highlightOf(const Vector3f& light, const Vector3f& eye)
{
    Vector3f point = light;
    for (int k = 0; k < 100; ++k) point = (light + (eye - point).normalized()).normalized();
    return point;
}

TEST(Finish, HighlightIsWhereTheHalfVectorIsTheNormal)
{
    for (const Vector3f& way : {Vector3f(0.6f, 0.7f, 0.4f), Vector3f(-0.5f, 0.3f, 0.8f)}) {
        RenderSettings settings = frontOf(0.0f);
        settings.light.direction = way;
        settings.light.intensity = 0.6f;
        const Image image = drawn(ballOf({0, 0, 0}, {Finish::Plastic, 0.3f, -1.0f}), settings);
        // The middle of what is brighter than half of the brightest, which is not cut off.
        float brightest = 0.0f;
        for (uint32_t i = 0; i < SIZE * SIZE; ++i) brightest = std::max(brightest, lightAt(image, i % SIZE, i / SIZE));
        ASSERT_LT(brightest, 0.99f);
        ASSERT_GT(brightest, 0.05f);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (uint32_t i = 0; i < SIZE * SIZE; ++i) {
            const uint32_t x = i % SIZE, y = i / SIZE;
            if (lightAt(image, x, y) > 0.9f * brightest) sum += Eigen::Vector3d(x + 0.5, y + 0.5, 1.0);
        }
        const Vector3f point = highlightOf(way.normalized(), {0, 0, 8});
        const float scale = 0.5f * SIZE / std::tan(8.0f * 3.14159265f / 180.0f) / (8.0f - point.z());
        EXPECT_NEAR(sum.x() / sum.z(), 0.5 * SIZE + scale * point.x(), 1.0);
        EXPECT_NEAR(sum.y() / sum.z(), 0.5 * SIZE - scale * point.y(), 1.0);
    }
}

/// The mean difference of two pictures' green, the second turned by a quarter to the left `quarters` times.
double differenceOf(const Image& a, const Image& b, int quarters)
{
    double sum = 0.0;
    for (uint32_t y = 0; y < SIZE; ++y)
        for (uint32_t x = 0; x < SIZE; ++x) {
            uint32_t u = x, v = y;
            for (int k = 0; k < quarters; ++k) {
                const uint32_t old = u;
                u = v;
                v = SIZE - 1 - old;
            }
            sum += std::abs(pixelAt(a, x, y).y() - pixelAt(b, u, v).y());
        }
    return sum / (SIZE * SIZE);
}

TEST(Finish, PatternsTurnWithTheBody)
{
    const auto picture = [](Finish finish, const Quaternionf& turn) {
        StillWorld still(0.14f);
        still.world.materials[0].finish.word = finish;
        still.addBody(cubeLattice(5, 0.28f), {0, 0, 0}, turn);
        return drawn(still.world, frontOf(0.7f));
    };
    const Quaternionf quarter(Eigen::AngleAxisf(1.57079633f, Vector3f::UnitZ()));
    const auto differences = [&](Finish finish) {
        const Image before = picture(finish, Quaternionf::Identity()), after = picture(finish, quarter);
        return std::pair{differenceOf(before, after, 1), differenceOf(before, after, 0)};
    };
    // Taps of the shade and edges do not turn with the picture, which a body without a pattern shows, too.
    const auto [shade, shadeAsItWas] = differences(Finish::Plastic);
    for (const Finish finish : {Finish::Wood, Finish::Checker, Finish::Brushed}) {
        const auto [turned, asItWas] = differences(finish);
        EXPECT_LT(turned, shade + 0.25) << int(finish);
        EXPECT_GT(asItWas, shadeAsItWas + 0.5) << int(finish);
    }
}

TEST(Finish, DefaultChangesNoPicture)
{
    const auto picture = [](Finish finish) {
        StillWorld still(0.1f);
        still.addGround();
        still.world.materials[1].finish.word = finish;  // nothing is made of it but body 1
        still.addBody(cubeLattice(3, 0.2f), {0, 0.3f, 0});
        RenderSettings settings = lookFrom({2, 1, 3}, {0, 0.3f, 0}, SIZE, SIZE);
        return drawn(still.world, settings).rgb;
    };
    EXPECT_EQ(picture(Finish::Default), picture(Finish::Metal));
}

TEST(Finish, KeepsWhatAModelSays)
{
    SkinMaterial material;
    EXPECT_EQ(modelFinish(material), SurfaceFinish());
    material.roughness = 0.25f;
    material.metalness = 1.0f;
    EXPECT_FLOAT_EQ(lookOf(modelFinish(material)).roughness, 0.25f);
    EXPECT_FLOAT_EQ(lookOf(modelFinish(material)).metalness, 1.0f);
}

}  // namespace
}  // namespace knuckle::test
