#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float SPACING = 0.05f;
constexpr uint32_t SIZE = 160;

/// Red paint, 1 m wide, 0.6 m high and 0.3 m thick, that nothing is seen through.
World wallOfPaint()
{
    StillWorld still(SPACING);
    still.world.fluidSpacing = SPACING;
    still.world.materials[0].look = {DrawnAs::Surface, 0.0f, 100.0f};
    still.world.materials[0].color = {0.8f, 0.05f, 0.05f};
    std::vector<Vector3f> places;
    for (int z = -3; z < 3; ++z)
        for (int y = 0; y < 12; ++y)
            for (int x = -10; x < 10; ++x)
                places.push_back(SPACING * (Vector3f(float(x), float(y), float(z)).array() + 0.5f).matrix());
    addFluid(still.world, places);
    return still.world;
}

Image seen(const World& world)
{
    RenderSettings settings = lookFrom({0, 0.6f, 3}, {0, 0.25f, 0}, SIZE, SIZE);
    settings.colorBy = ColorBy::Material;
    settings.light.direction = {0, 1, 0.2f};
    return drawn(world, settings);
}

/// In the middle of the paint.
Eigen::Vector3i middleOf(const Image& image)
{
    return pixelAt(image, SIZE / 2, SIZE / 2);
}

Image withGlass(float z)
{
    World world = wallOfPaint();
    Collider ball;
    ball.shape = ColliderShape::Sphere;
    ball.position = {0, 0.3f, z};
    ball.radius = 0.2f;
    ball.color = {0.02f, 0.02f, 1.0f};
    ball.finish.word = Finish::Glass;
    world.colliders.push_back(ball);
    return seen(world);
}

TEST(FluidSide, GlassIsHiddenBehindPaintAndSeenBeforeIt)
{
    const Eigen::Vector3i paint = middleOf(seen(wallOfPaint()));
    ASSERT_GT(paint.x(), paint.z() + 60);
    // Light and shade of the paint are the same; its depth is that of the surface.
    EXPECT_LE((middleOf(withGlass(-0.6f)) - paint).cwiseAbs().maxCoeff(), 2) << "behind";
    // Blue glass takes what is red of the light through it.
    EXPECT_LT(middleOf(withGlass(0.6f)).x(), paint.x() - 60) << "in front";
}

TEST(FluidSide, APolishedFloorMirrorsPaint)
{
    const auto redness = [](FloorLook look) {
        World world = wallOfPaint();
        Collider floor;
        floor.shape = ColliderShape::Plane;
        floor.floor = look;
        world.colliders.push_back(floor);
        // The paint's foot, 2.85 m away, is a third of the picture's height below its middle at most.
        const Eigen::Vector3i below = pixelAt(seen(world), SIZE / 2, SIZE / 2 + 30);
        return below.x() - below.z();
    };
    EXPECT_GT(redness(FloorLook::Mirror), redness(FloorLook::Studio) + 15);
}

}  // namespace
}  // namespace knuckle::test
