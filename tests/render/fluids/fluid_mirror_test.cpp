#include <cmath>
#include <numbers>

#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.04f, TOP = 0.2f;
constexpr uint32_t SIZE = 240;

/// Black water, and a white wall at z = -0.6 that stands in it.
World poolBeforeWall()
{
    StillWorld still(0.04f);
    World& world = still.world;
    const auto add = [&](const Vector3f& middle, const Vector3f& halves, float white) {
        Collider& box = still.addCollider(ColliderShape::Box, middle);
        box.halfExtents = halves;
        box.color = {white, white, white};
    };
    add({0, -0.1f, 0}, {0.6f, 0.1f, 0.6f}, 0.0f);
    add({0, 0.5f, -0.7f}, {0.6f, 0.5f, 0.1f}, 0.5f);
    world.fluidSpacing = SPACING;
    world.materials[0].look = {DrawnAs::Surface, 0.0f, 0.0f};
    std::vector<Vector3f> places;
    for (int z = -15; z < 15; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = -15; x < 15; ++x)
                places.push_back(SPACING * (Vector3f(float(x), float(y), float(z)).array() + 0.5f).matrix());
    addFluid(world, places);
    return world;
}

TEST(FluidMirror, ShowsWhatStandsBehindByFresnelsLaw)
{
    const World world = poolBeforeWall();
    std::vector<uint32_t> forms;
    for (const Particle& p : world.particles)
        forms.push_back(p.position.y() > TOP - SPACING ? packedForm({0, 1, 0}, 0.66, 1.23) : 0);
    // At 15 degrees to the surface, at a place 0.3 m before the wall: the mirrored ray meets it 8 cm above the water.
    const double slant = 15.0 * std::numbers::pi / 180.0;
    const Vector3f at(0.0f, TOP, -0.3f);
    const Vector3f back(0.0f, static_cast<float>(std::sin(slant)), static_cast<float>(std::cos(slant)));
    RenderSettings settings = lookFrom(at + 3.0f * back, at, SIZE, SIZE);
    settings.camera.fieldOfView = 20.0f;
    settings.colorBy = ColorBy::Material;
    settings.toneMap = ToneMap::Linear;
    settings.light.direction = {0.0f, 0.3f, 1.0f};
    settings.light.skyColor = settings.light.groundColor = {0, 0, 0};
    const Image image = drawn(world, settings, 0.0, forms);
    // Of the picture's height, 20 degrees: where the wall is at that height itself.
    const double wall = TOP + 0.3 * std::tan(slant), focal = 0.5 * SIZE / std::tan(10.0 * std::numbers::pi / 180.0);
    const Vector3f eye = at + 3.0f * back;
    const double tilt = slant - std::atan2(double(eye.y()) - wall, double(eye.z()) + 0.6);
    const auto row = static_cast<uint32_t>(0.5 * SIZE - focal * std::tan(tilt));
    const auto light = [&](uint32_t y) {
        double sum = 0.0;
        for (uint32_t x = SIZE / 2 - 20; x < SIZE / 2 + 20; ++x)
            sum += std::pow(pixelAt(image, x, y).y() / 255.0, 2.2) / 40.0;
        return sum;
    };
    // Schlick's form of it.
    const double share = 0.02 + 0.98 * std::pow(1.0 - std::sin(slant), 5.0);
    ASSERT_GT(light(row), 0.2);
    // Pixels hold the dimmer light to a fiftieth; bumps of a degree change the share by a tenth, their mean by less.
    EXPECT_NEAR(light(SIZE / 2) / light(row), share, 0.07 * share);
}

}  // namespace
}  // namespace knuckle::test
