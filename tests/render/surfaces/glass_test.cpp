#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 240;
constexpr float RADIUS = 0.3f, DISTANCE = 3.0f, WALL = -1.0f;

/// A ball before a wall at z = WALL that is black up to x = edge and white beyond.
World ballBeforeWall(float edge, Finish finish)
{
    StillWorld still(0.05f);
    for (const float side : {-1.0f, 1.0f}) {
        Collider& wall = still.addCollider(ColliderShape::Box, {edge + 2.0f * side, 0.0f, WALL - 0.1f});
        wall.halfExtents = {2.0f, 4.0f, 0.1f};
        wall.color = side < 0.0f ? Vector3f(0.02f, 0.02f, 0.02f) : Vector3f(0.9f, 0.9f, 0.9f);
    }
    Collider& ball = still.addCollider(ColliderShape::Sphere, {0, 0, 0});
    ball.radius = RADIUS;
    ball.color = {1, 1, 1};
    ball.finish.word = finish;
    return still.world;
}

RenderSettings straightLook()
{
    RenderSettings settings = lookFrom({0, 0, DISTANCE}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = 20.0f;
    settings.toneMap = ToneMap::Linear;
    settings.light.intensity = 0.0f;
    settings.light.skyColor = settings.light.groundColor = {1, 1, 1};
    return settings;
}

double lightOf(int shown)
{
    return std::pow((shown / 255.0 + 0.055) / 1.055, 2.4);
}

/// Where a ray through the middle row meets the wall, as x, by Snell's law twice.
double metThroughBall(double column, double index)
{
    const double focal = 0.5 * SIZE / std::tan(10.0 * std::numbers::pi / 180.0);
    Eigen::Vector2d p(0.0, DISTANCE), d = Eigen::Vector2d((column - 0.5 * SIZE) / focal, -1.0).normalized();
    const auto bend = [](const Eigen::Vector2d& way, const Eigen::Vector2d& n, double ratio) -> Eigen::Vector2d {
        const double c = -way.dot(n), s = 1.0 - ratio * ratio * (1.0 - c * c);
        return ratio * way + (ratio * c - std::sqrt(s)) * n;
    };
    const double b = p.dot(d), root = std::sqrt(b * b - p.squaredNorm() + RADIUS * RADIUS);
    p += (-b - root) * d;
    d = bend(d, p.normalized(), 1.0 / index);
    p += -2.0 * p.dot(d) * d;
    d = bend(d, -p.normalized(), index);
    return p.x() + (WALL - p.y()) / d.y() * d.x();
}

TEST(Glass, ABallShowsWhatIsBehindItUpsideDownBySnellsLaw)
{
    for (const float edge : {-0.1f, 0.12f}) {
        const Image image = drawn(ballBeforeWall(edge, Finish::Glass), straightLook());
        // Turned around: what is right of the edge is left of its image. Columns of the inner half of the ball.
        double expected = 0.0, found = 0.0;
        const int black = pixelAt(image, SIZE / 2 + 33, SIZE / 2).y(),
                  white = pixelAt(image, SIZE / 2 - 34, SIZE / 2).y();
        ASSERT_GT(white, black + 100);
        for (uint32_t x = SIZE / 2 - 34; x < SIZE / 2 + 34; ++x) {
            for (int k = 0; k < 10; ++k) expected += metThroughBall(x + 0.1 * k + 0.05, 1.5) > edge ? 0.1 : 0.0;
            found += (pixelAt(image, x, SIZE / 2).y() - black) / double(white - black);
        }
        ASSERT_GT(expected, 5.0);
        ASSERT_LT(expected, 63.0);
        EXPECT_NEAR(found, expected, 1.0) << edge;
    }
}

TEST(Glass, ThickGlassColoursWhatIsBehindIt)
{
    World clear = ballBeforeWall(-3.0f, Finish::Glass), green = clear;
    green.colliders.back().color = {0.25f, 0.5f, 0.25f};
    const auto lightAt = [](const World& world, uint32_t x) {
        return lightOf(pixelAt(drawn(world, straightLook()), x, SIZE / 2).x());
    };
    // Through the middle light goes the whole diameter. 0.04 of the sky behind the camera is mirrored, which is 0.95 at
    // the horizon. The wall is seen beside the ball.
    const double wall = lightAt(clear, 10), mirrored = 0.04 * 0.95;
    EXPECT_NEAR(lightAt(clear, SIZE / 2), 0.96 * wall + mirrored, 0.02);
    EXPECT_NEAR(lightAt(green, SIZE / 2), 0.96 * 0.25 * wall + mirrored, 0.01);
}

TEST(Emission, AddsItsColourToWhatComesBack)
{
    World dark = ballBeforeWall(0.0f, Finish::Matte);
    Collider& lamp = dark.colliders.back();
    lamp.color = {0.5f, 0.25f, 0.125f};
    lamp.finish.emission = 0.8f;
    RenderSettings settings = straightLook();
    settings.light.skyColor = settings.light.groundColor = {0, 0, 0};
    const Eigen::Vector3i shown = pixelAt(drawn(dark, settings), SIZE / 2, SIZE / 2);
    for (const int axis : {0, 1, 2}) {
        // Colours have 8 bits of their root, pixels 8 bits.
        const double sent = 0.8 * lamp.color[axis];
        EXPECT_NEAR(lightOf(shown[axis]), sent, 0.03 * sent + 0.002) << axis;
    }
}

}  // namespace
}  // namespace knuckle::test
