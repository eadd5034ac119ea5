#include <cmath>
#include <numbers>

#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 160;
constexpr float HEIGHT = 8.0f, FIELD_OF_VIEW = 30.0f;

/// Light of the ground at a place, seen from straight above.
double groundLight(const Image& image, float x, float z)
{
    const float slope = std::tan(FIELD_OF_VIEW * std::numbers::pi_v<float> / 360.0f), half = 0.5f * SIZE;
    const auto column = static_cast<uint32_t>(half * (1.0f + x / (HEIGHT * slope)));
    const auto row = static_cast<uint32_t>(half * (1.0f + z / (HEIGHT * slope)));
    return std::pow((pixelAt(image, column, row).y() / 255.0 + 0.055) / 1.055, 2.4);
}

/// A ball of 0.25 m at (0, 0.6, 0) and a light beside the key light, which is out.
Image litBy(const LightSource& light)
{
    StillWorld still(0.25f);
    // Ground would fade into the haze.
    Collider& floor = still.addCollider(ColliderShape::Box, {0, -0.1f, 0});
    floor.halfExtents = {4, 0.1f, 4};
    floor.color = {0.8f, 0.8f, 0.8f};
    still.addBody({Vector3f::Zero()}, {0.0f, 0.6f, 0.0f});
    RenderSettings settings = lookFrom({0, HEIGHT, 0.001f}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = FIELD_OF_VIEW;
    settings.toneMap = ToneMap::Linear;
    settings.light.intensity = 0.0f;
    settings.light.skyColor = settings.light.groundColor = {0, 0, 0};
    settings.lights = {light};
    return drawn(still.world, settings);
}

TEST(LampShadow, FallsWhereRaysFromTheLampMeetTheGround)
{
    LightSource lamp;
    lamp.place = {-4.0f, 3.6f, 0.0f};
    lamp.intensity = 20.0f;
    const Image image = litBy(lamp);
    // A ray from the lamp through the ball's middle comes down by 3 m in 4 m, and from there meets the ground 0.8 m on.
    EXPECT_LT(groundLight(image, 0.8f, 0.0f), 0.01);
    // The cone around the ball has a half angle of asin(0.25 / 5): 0.25 m to the sides there, and 1.2 to both ends.
    for (const float aside : {-0.2f, 0.2f}) EXPECT_LT(groundLight(image, 0.8f, aside), 0.01) << aside;
    for (const float aside : {-0.45f, 0.45f}) EXPECT_GT(groundLight(image, 0.8f, aside), 0.02) << aside;
    // Elsewhere Lambert's law and the square of the distance hold.
    const auto expected = [](double x, double z) { return std::pow(3.6 * 3.6 + (x + 4.0) * (x + 4.0) + z * z, -1.5); };
    const double ratio = expected(1.6, 0.0) / expected(0.0, 1.0);
    EXPECT_NEAR(groundLight(image, 1.6f, 0.0f) / groundLight(image, 0.0f, 1.0f), ratio, 0.05 * ratio);
}

TEST(LampShadow, OfADirectionalLightIsParallel)
{
    LightSource sun;
    sun.isPoint = false;
    sun.place = {-1.0f, 1.0f, 0.0f};
    sun.intensity = 2.0f;
    const Image image = litBy(sun);
    // At 45 degrees: as far to the side as the ball is high.
    for (const float aside : {-0.15f, 0.0f, 0.15f}) EXPECT_LT(groundLight(image, 0.6f, aside), 0.01) << aside;
    for (const float aside : {-0.4f, 0.4f}) EXPECT_GT(groundLight(image, 0.6f, aside), 0.1) << aside;
    EXPECT_GT(groundLight(image, 1.2f, 0.0f), 0.1);
}

}  // namespace
}  // namespace knuckle::test
