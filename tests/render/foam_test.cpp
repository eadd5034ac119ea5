#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t SIZE = 160;
constexpr float SPACING = 0.04f;

/// A black floor, and far to the side a drop of fluid, so that its surface is drawn.
World darkWorld()
{
    StillWorld still(0.04f);
    Collider& floor = still.addCollider(ColliderShape::Box, {0, -0.1f, 0});
    floor.halfExtents = {30, 0.1f, 30};
    floor.color = {0.02f, 0.02f, 0.02f};
    still.world.fluidSpacing = SPACING;
    addFluid(still.world, {{-20, 1, 0}});
    return still.world;
}

RenderSettings fromAbove()
{
    RenderSettings settings = lookFrom({0, 3, 0.3f}, {0, 0, 0}, SIZE, SIZE);
    settings.camera.fieldOfView = 30.0f;
    settings.colorBy = ColorBy::Material;
    return settings;
}

/// The picture with points of foam.
Image drawnWith(const World& world, const std::vector<gpu::vec4>& places)
{
    Gpu& gpu = sharedGpu();
    const StillBuffers buffers(world);
    const Buffer<gpu::vec4> foam("foam", places);
    ParticleView view = buffers.view();
    view.foamPlaces = foam.id();
    view.foamCount = static_cast<uint32_t>(places.size());
    Renderer renderer(gpu, world, fromAbove());
    renderer.draw(view, 0.0);
    Image image = renderer.readImage();
    EXPECT_NO_THROW(gpu.checkErrors());
    return image;
}

/// A square of points about the origin, 0.3 m a side.
std::vector<gpu::vec4> patch(float height, float opacity)
{
    std::vector<gpu::vec4> places;
    for (int z = 0; z < 60; ++z)
        for (int x = 0; x < 60; ++x)
            places.push_back({0.005f * float(x) - 0.15f, height, 0.005f * float(z) - 0.15f, opacity});
    return places;
}

double lightIn(const Image& image, uint32_t x, uint32_t y)
{
    return pixelAt(image, x, y).sum() / 3.0;
}

TEST(Foam, IsWhiteWherePointsAre)
{
    const World world = darkWorld();
    const Image bare = drawnWith(world, {}), white = drawnWith(world, patch(0.5f, 1.0f)),
                faint = drawnWith(world, patch(0.5f, 0.05f)), none = drawnWith(world, patch(0.5f, 0.0f));
    const double dark = lightIn(bare, SIZE / 2, SIZE / 2), most = lightIn(white, SIZE / 2, SIZE / 2);
    EXPECT_LT(dark, 80.0);
    EXPECT_GT(most, 190.0);
    const Eigen::Vector3i color = pixelAt(white, SIZE / 2, SIZE / 2);
    EXPECT_LT(color.maxCoeff() - color.minCoeff(), 40) << "not white but coloured";
    EXPECT_GT(lightIn(faint, SIZE / 2, SIZE / 2), dark + 8.0);
    EXPECT_LT(lightIn(faint, SIZE / 2, SIZE / 2), most - 20.0);
    EXPECT_EQ(none.rgb, bare.rgb);
    EXPECT_EQ(pixelAt(white, 10, 10), pixelAt(bare, 10, 10));
}

TEST(Foam, IsHiddenBySolids)
{
    World world = darkWorld();
    Collider lid;
    lid.shape = ColliderShape::Box;
    lid.position = {0, 1.0f, 0};
    lid.halfExtents = {1, 0.05f, 1};
    lid.color = {0.02f, 0.02f, 0.02f};
    world.colliders.push_back(lid);
    EXPECT_EQ(drawnWith(world, patch(0.5f, 1.0f)).rgb, drawnWith(world, {}).rgb);
    EXPECT_NE(drawnWith(world, patch(1.5f, 1.0f)).rgb, drawnWith(world, {}).rgb);
}

/// What a far point adds to the picture hardly depends on where between pixels it is. On a dark floor it would: what is
/// displayed of light is no linear function of it.
TEST(Foam, DoesNotFlickerAsItMoves)
{
    World world = darkWorld();
    world.colliders[0].color = {0.2f, 0.2f, 0.2f};
    const Image bare = drawnWith(world, {});
    double low = 1e9, high = 0.0;
    for (int k = 0; k < 12; ++k) {
        const Image one = drawnWith(world, {{0.0011f * float(k), 0.5f, 0.0007f * float(k), 1.0f}});
        double sum = 0.0;
        for (size_t i = 0; i < one.rgb.size(); ++i) sum += double(one.rgb[i]) - double(bare.rgb[i]);
        low = std::min(low, sum);
        high = std::max(high, sum);
    }
    EXPECT_GT(low, 30.0);
    EXPECT_LT(high, 1.3 * low);
}

/// Deeper bubbles are dimmer.
TEST(Foam, IsDimmedByFluidBeforeIt)
{
    World world = darkWorld();
    world.materials[0].look = {DrawnAs::Surface, 4.0f, 0.0f};
    world.materials[0].color = {0.1f, 0.3f, 0.8f};
    std::vector<Vector3f> places;
    for (const Vector3f& p : cubeLattice(12, SPACING)) places.push_back(p + Vector3f(0, 0.3f, 0));
    addFluid(world, places);
    const Image bare = drawnWith(world, {});
    double last = 1e9;
    for (const float height : {0.55f, 0.45f, 0.3f, 0.12f}) {
        const Image image = drawnWith(world, patch(height, 1.0f));
        const double light = lightIn(image, SIZE / 2, SIZE / 2) - lightIn(bare, SIZE / 2, SIZE / 2);
        EXPECT_LT(light, last - 5.0) << height;
        EXPECT_GT(light, 0.0) << height;
        last = light;
    }
}

}  // namespace
}  // namespace knuckle::test
