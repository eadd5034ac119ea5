#include <cmath>
#include <numbers>
#include <optional>

#include "sim/base/errors.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 160;
constexpr float FIELD_OF_VIEW = 40.0f;

/// Spheres of one radius, alternately red and blue, seen along -z from (0, 0, distance).
World redAndBlue(float radius, const std::vector<Vector3f>& centres)
{
    StillWorld still(radius);
    for (const Vector3f& centre : centres) still.addBody({Vector3f::Zero()}, centre);
    still.world.materials[0].color = {0.9f, 0.02f, 0.02f};
    still.world.materials[1].color = {0.02f, 0.02f, 0.9f};
    return still.world;
}

RenderSettings flatColors(float distance)
{
    RenderSettings settings = lookFrom({0, 0, distance}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = FIELD_OF_VIEW;
    settings.colorBy = ColorBy::Material;
    return settings;
}

/// The first sphere that a ray from the eye meets: the picture must show this one.
int firstHit(const World& world, float distance, uint32_t x, uint32_t y)
{
    const float slope = std::tan(FIELD_OF_VIEW * std::numbers::pi_v<float> / 360.0f) * 2.0f / SIZE;
    const Vector3f ray((float(x) + 0.5f - 0.5f * SIZE) * slope, (0.5f * SIZE - float(y) - 0.5f) * slope, -1.0f);
    int hit = -1;
    float nearest = 1e30f;
    for (int i = 0; i < static_cast<int>(world.particles.size()); ++i) {
        const Vector3f c = world.particles[i].position - Vector3f(0, 0, distance);
        const float b = c.dot(ray), a = ray.squaredNorm();
        const float root = b * b - a * (c.squaredNorm() - world.particleRadius * world.particleRadius);
        if (root < 0.0f) continue;
        const float t = (b - std::sqrt(root)) / a;
        if (t <= 0.0f || t >= nearest) continue;
        nearest = t;
        hit = i;
    }
    return hit;
}

/// -1 the backdrop, 0 red, 1 blue: the sky is nearly grey, and a highlight only adds grey.
int shown(const Eigen::Vector3i& color)
{
    const int redness = color.x() - color.z();
    return redness > 35 ? 0 : redness < -60 ? 1 : -1;
}

/// Every pixel whose eight neighbours expect the same sphere must show it: the edge filter mixes the others.
void expectAsRayCast(const World& world, float distance)
{
    const Image image = drawn(world, flatColors(distance));
    int wrong = 0, judged = 0;
    for (uint32_t y = 1; y + 1 < SIZE; ++y) {
        for (uint32_t x = 1; x + 1 < SIZE; ++x) {
            const int expected = firstHit(world, distance, x, y);
            bool inside = true;
            for (uint32_t n = 0; n < 9; ++n)
                inside = inside && firstHit(world, distance, x + n % 3 - 1, y + n / 3 - 1) == expected;
            if (!inside) continue;
            ++judged;
            wrong += shown(pixelAt(image, x, y)) != (expected < 0 ? -1 : expected % 2) ? 1 : 0;
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << judged;
    EXPECT_GT(judged, static_cast<int>(SIZE * SIZE / 2));
}

TEST(SphereGeometry, IntersectingSpheresMeetWhereTheirSurfacesDo)
{
    expectAsRayCast(redAndBlue(0.5f, {{-0.25f, 0, 0}, {0.25f, 0.1f, -0.2f}, {0.2f, -0.5f, 0.3f}}), 4.0f);
}

TEST(SphereGeometry, SpheresFarOffTheAxisAreEllipsesAndStayWhole)
{
    expectAsRayCast(redAndBlue(0.4f, {{1.3f, 1.2f, 0}, {-1.45f, -1.0f, 0.2f}, {-1.2f, 1.6f, 0.3f}}), 4.0f);
}

TEST(SphereGeometry, SpheresLargerThanTheDriversPointsStayWhole)
{
    // The first fills the picture; the centre of the second is beside the picture and behind the first's front.
    expectAsRayCast(redAndBlue(1.0f, {{-0.6f, 0, 0}, {1.1f, 0.9f, 0.4f}}), 2.2f);
}

TEST(SphereGeometry, TheSilhouetteOfOneSphereHasTheClosedFormRadius)
{
    const float radius = 0.5f, distance = 3.0f;
    const Image image = drawn(redAndBlue(radius, {{0, 0, 0}}), flatColors(distance));
    int covered = 0;
    for (uint32_t y = 0; y < SIZE; ++y)
        for (uint32_t x = 0; x < SIZE; ++x) covered += shown(pixelAt(image, x, y)) == 0 ? 1 : 0;
    // The cone that touches the sphere has the slope r / sqrt(d^2 - r^2), not r / d.
    const double slope = radius / std::sqrt(distance * distance - radius * radius);
    const double expected = slope / std::tan(FIELD_OF_VIEW * std::numbers::pi / 360.0) * SIZE / 2.0;
    // Mixed edge pixels may count as red or not: half a pixel of the radius at most.
    EXPECT_NEAR(std::sqrt(covered / std::numbers::pi), expected, 0.5);
}

TEST(SphereGeometry, LeavingOutBuriedParticlesOpensNoHoles)
{
    // 20 particles a side are five cells of the burial grid: the inner ones are buried, and hide those behind. The back
    // is blue, to distinguish it from the front.
    std::vector<Vector3f> front, back;
    for (const Vector3f& p : cubeLattice(20, 0.1f)) (p.z() < -0.5f ? back : front).push_back(p);
    const Quaternionf turn(Eigen::AngleAxisf(0.5f, Vector3f(1, 2, 0).normalized()));
    StillWorld still(0.05f);
    still.addBody(front, {0, 0, 0}, turn);
    still.addBody(back, {0, 0, 0}, turn);
    still.world.materials[0].color = {0.9f, 0.02f, 0.02f};
    still.world.materials[1].color = {0.02f, 0.02f, 0.9f};
    const Image image = drawn(still.world, flatColors(6.0f));
    // The cube's half side of 1 m covers 37 pixels from the middle, at any rotation.
    const float reach = 35.0f, middle = 0.5f * SIZE;
    int holes = 0;
    for (uint32_t y = 0; y < SIZE; ++y)
        for (uint32_t x = 0; x < SIZE; ++x)
            holes += std::hypot(float(x) - middle, float(y) - middle) < reach && shown(pixelAt(image, x, y)) != 0;
    EXPECT_EQ(holes, 0);
}

TEST(SphereGeometry, LeavingOutBuriedParticlesOpensNoHolesBetweenRows)
{
    // Seen along rows that are straight to a fifth of a diameter, so that rays go many layers deep between them.
    std::vector<Vector3f> places = cubeLattice(28, 0.1f);
    uint32_t word = 1;
    for (Vector3f& place : places) {
        for (float& along : place) {
            word = word * 1664525u + 1013904223u;
            along += 0.04f * (static_cast<float>(word >> 8) / 16777216.0f - 0.5f);
        }
    }
    StillWorld still(0.05f);
    still.addBody(places, {0, 0, 0});
    still.world.materials[0].color = {0.9f, 0.02f, 0.02f};
    const float distance = 4.0f;
    const Image image = drawn(still.world, flatColors(distance));
    int holes = 0;
    for (uint32_t y = SIZE / 4; y < 3 * SIZE / 4; ++y) {
        for (uint32_t x = SIZE / 4; x < 3 * SIZE / 4; ++x) {
            const bool meets = firstHit(still.world, distance, x, y) >= 0;
            holes += meets && shown(pixelAt(image, x, y)) != 0;
        }
    }
    EXPECT_EQ(holes, 0);
}

/// The mean brightness of the ground at `x` in front of a camera that looks straight down on the origin.
int groundBrightness(const Image& image, float x, float height)
{
    const float slope = std::tan(FIELD_OF_VIEW * std::numbers::pi_v<float> / 360.0f);
    const float place = 0.5f * SIZE * (1.0f + x / (height * slope));
    return pixelAt(image, static_cast<uint32_t>(place), SIZE / 2).sum() / 3;
}

TEST(Shadow, ASphereShadesTheGroundAlongTheLightAndOnlyThere)
{
    StillWorld still(0.3f);
    still.addGround();
    still.addBody({Vector3f::Zero()}, {-1.0f, 1.5f, 0.0f});
    RenderSettings settings = lookFrom({0, 8, 0}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = FIELD_OF_VIEW;
    settings.light.softness = 0.0f;
    // The light comes down at a slope of 1, from -x: the shadow's centre is 1.5 m to the +x of the sphere's.
    settings.light.direction = {-1.0f, 1.0f, 0.0f};
    const Image image = drawn(still.world, settings);
    // Along x the shadow is an ellipse of half-width r * sqrt(2) = 0.42 m about x = 0.5 m.
    const int open = groundBrightness(image, 1.8f, 8.0f);
    // A pixel is 36 mm wide and light is stored for every other one, mixed over two: 0.15 m to each side of the edge.
    for (const float inside : {-0.25f, 0.0f, 0.25f})
        EXPECT_LT(groundBrightness(image, 0.5f + inside, 8.0f), open - 20) << inside;
    for (const float outside : {-0.6f, 0.6f})
        EXPECT_NEAR(groundBrightness(image, 0.5f + outside, 8.0f), open, 10) << outside;
}

}  // namespace
}  // namespace knuckle::test
