#include <algorithm>
#include <functional>

#include "render/compare/comparison.h"
#include "render/view/bounds_margin.h"
#include "render/view/camera.h"
#include "tests/message_of.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr uint32_t WIDTH = 240, HEIGHT = 120, SIZE = 160;

/// One red body of the particles, alone in the void unless a ground is requested.
World redBody(const std::vector<Vector3f>& particles, const Vector3f& position, bool ground = false)
{
    StillWorld still(0.1f);
    if (ground) still.addGround();
    still.addBody(particles, position);
    still.world.materials[0].color = {0.9f, 0.02f, 0.02f};
    return still.world;
}

std::vector<Vector3f> row(const Vector3f& step, int count)
{
    std::vector<Vector3f> points;
    for (int i = 0; i < count; ++i) points.push_back(static_cast<float>(i) * step);
    return points;
}

RenderSettings automatic()
{
    RenderSettings settings;
    settings.width = WIDTH;
    settings.height = HEIGHT;
    settings.colorBy = ColorBy::Material;
    return settings;
}

/// Red pixels: their distance from the sides [pixels], and their width and height as shares of the picture.
struct Framing {
    int left = WIDTH, right = WIDTH, top = HEIGHT, bottom = HEIGHT;

    explicit Framing(const Image& image)
    {
        for (int y = 0; y < static_cast<int>(image.height); ++y) {
            for (int x = 0; x < static_cast<int>(image.width); ++x) {
                const Eigen::Vector3i color = pixelAt(image, uint32_t(x), uint32_t(y));
                if (color.x() - color.z() <= 35) continue;
                left = std::min(left, x);
                right = std::min(right, int(image.width) - 1 - x);
                top = std::min(top, y);
                bottom = std::min(bottom, int(image.height) - 1 - y);
            }
        }
    }
    float width() const { return 1.0f - float(left + right) / WIDTH; }
    float height() const { return 1.0f - float(top + bottom) / HEIGHT; }
};

TEST(Camera, AnAutomaticCameraShowsAllAsLargeAsItCan)
{
    // Thin rows fill their boxes, whose images fill 0.85 of the picture in one direction. Spheres do not fill the
    // corners at the row's near end, and two pixels of the edges may be mixed: 2 %, or 4 on the way up.
    for (const Vector3f& step : {Vector3f(0.2f, 0, 0), Vector3f(0, 0.2f, 0)}) {
        const Framing framing(drawn(redBody(row(step, 40), {3, -1, 2}), automatic()));
        const float share = std::max(framing.width(), framing.height());
        EXPECT_GT(share, 0.78f) << step.transpose();
        EXPECT_LT(share, 0.89f) << step.transpose();
        const bool wide = framing.width() > framing.height();
        EXPECT_NEAR(wide ? framing.left : framing.top, wide ? framing.right : framing.bottom, 5) << step.transpose();
    }
}

TEST(Camera, AnAutomaticCameraLeavesRoomForTheFallToTheGround)
{
    const Framing framing(drawn(redBody(cubeLattice(4, 0.2f), {0, 2.4f, 0}, true), automatic()));
    // The cube of 0.8 m hangs 2 m above the ground; the camera looks ahead only by the cube's own size.
    EXPECT_GT(framing.bottom, 2 * framing.top);
    EXPECT_GT(framing.height(), 0.3f);
}

TEST(Camera, AnAutomaticCameraShowsTheManyEvenWhereOneHasRolledAway)
{
    std::vector<Vector3f> particles = cubeLattice(10, 0.2f);
    particles.push_back({25, 0, 0});
    const Framing framing(drawn(redBody(particles, {0, 0, 0}), automatic()));
    // The cube of 2 m is 8 % of the whole row. Three standard deviations are 2.9 m to each side, since the stray
    // particle adds 25 m / sqrt(1001) to the cube's own: the box as a whole at least doubles.
    EXPECT_GT(framing.height(), 0.4f);
}

TEST(Camera, MovesToWhatMovedSmoothly)
{
    Gpu& gpu = sharedGpu();  // before there are buffers
    const World here = redBody(cubeLattice(3, 0.2f), {0, 0, 0}), there = redBody(cubeLattice(3, 0.2f), {0.3f, 0, 0});
    const StillBuffers before(here), after(there);
    for (const CameraKind kind : {CameraKind::Fixed, CameraKind::Follow}) {
        RenderSettings settings = automatic();
        settings.camera.kind = kind;
        settings.camera.follow = "body 0";
        Renderer renderer(gpu, here, settings);
        const auto picture = [&](const StillBuffers& buffers, double time) {
            renderer.draw(buffers.view(), time);
            return renderer.readImage();
        };
        const Image start = picture(before, 0.0);
        // A 60th of a second is much shorter than the camera's time: the body is off the middle, to the right.
        const Framing soon(picture(after, 1.0 / 60.0));
        EXPECT_GT(soon.left, soon.right + 20);
        renderer.look(after.view(), 50.0);
        const Framing late(picture(after, 100.0));
        EXPECT_NEAR(late.left, Framing(start).left, 2);
        EXPECT_NEAR(late.right, Framing(start).right, 2);
    }
}

/// A camera on its way to a body that has jumped, for each kind of camera that remembers its place.
TEST(Camera, AnotherRendererGoesOnFromTheState)
{
    Gpu& gpu = sharedGpu();  // before there are buffers
    const World here = redBody(cubeLattice(3, 0.2f), {0, 0, 0}), there = redBody(cubeLattice(3, 0.2f), {0.3f, 0, 0});
    const StillBuffers before(here), after(there);
    for (const CameraKind kind : {CameraKind::Fixed, CameraKind::Orbit, CameraKind::Follow}) {
        RenderSettings settings = automatic();
        settings.camera.kind = kind;
        settings.camera.follow = "body 0";
        Renderer whole(gpu, here, settings), second(gpu, here, settings);
        const auto look = [&](Renderer& renderer, double time) {
            renderer.draw(after.view(), time);
            return renderer.readImage().rgb;
        };
        whole.draw(before.view(), 0.0);
        whole.look(after.view(), 0.1);
        second.loadState(whole.saveState());
        for (const double time : {0.2, 0.3})
            EXPECT_TRUE(look(second, time) == look(whole, time)) << int(kind) << " at " << time;
        Renderer fresh(gpu, here, settings);
        EXPECT_FALSE(look(fresh, 0.3) == look(whole, 0.3)) << int(kind) << ": nothing to remember";
    }
}

TEST(Camera, AStateThatDoesNotFitIsRefused)
{
    Gpu& gpu = sharedGpu();  // before there are buffers
    const World world = redBody(cubeLattice(3, 0.2f), {0, 0, 0});
    const StillBuffers buffers(world);
    Renderer renderer(gpu, world, automatic());
    renderer.draw(buffers.view(), 0.0);
    const RendererState good = renderer.saveState();
    ASSERT_EQ(good.buffers.size(), 1u);
    const auto complaint = [&](const std::function<void(RendererState&)>& spoil) {
        RendererState bad = good;
        bad.lookedAt = 7.0;
        spoil(bad);
        std::string message = messageOf<std::logic_error>([&] { renderer.loadState(bad); });
        EXPECT_TRUE(renderer.saveState().buffers == good.buffers && renderer.saveState().lookedAt == good.lookedAt);
        return message;
    };
    const std::string advice = "; take one of the same world and settings",
                      bytes = std::to_string(sizeof(gpu::FrameView));
    for (const size_t size : {size_t{0}, sizeof(gpu::FrameView) - 1, sizeof(gpu::FrameView) + 16})
        EXPECT_EQ(
            complaint([&](RendererState& s) { s.buffers.at("view").resize(size); }),
            "the state has " + std::to_string(size) + " bytes of \"view\", and there are " + bytes + " here" + advice);
    EXPECT_EQ(complaint([](RendererState& s) { s.buffers.clear(); }),
              "the state has no \"view\", which is carried on here" + advice);
    EXPECT_EQ(complaint([](RendererState& s) { s.buffers["positions"].resize(16); }),
              "the state is of 2 buffers, of which 1 are carried on here" + advice);
}

TEST(Camera, AFollowingCameraSeesItsBodyTheSameWhereverItIs)
{
    RenderSettings settings;
    settings.width = settings.height = SIZE;
    settings.camera.kind = CameraKind::Follow;
    settings.camera.follow = "body 1";
    settings.camera.automatic = false;
    settings.camera.position = {0.5f, 0.6f, 2.0f};
    settings.camera.target = Vector3f::Zero();
    const auto picture = [&](const Vector3f& place) {
        StillWorld still(0.1f);
        still.addBody({Vector3f::Zero()}, {0, -9, 0});
        still.addBody(cubeLattice(2, 0.2f), place);
        return drawn(still.world, settings);
    };
    const Image here = picture({0, 0, 0}), there = picture({7.0f, 3.0f, -2.0f});
    // Only rounding of the larger coordinates and the places of the shadow map's texels differ.
    CompareSettings edges;
    edges.threshold = 24.0f;
    const PictureComparison comparison = comparePictures(pictureOf(here), pictureOf(there), edges);
    EXPECT_LT(comparison.differences.changed, SIZE * SIZE / 100);
    EXPECT_NE(pixelAt(here, SIZE / 2, SIZE / 2), pixelAt(here, 4, SIZE / 2));
}

/// The mean place of what is redder than anything else in the picture of a camera that follows it [shares of the
/// picture from its middle]; far away if nothing is.
float offMiddle(const Image& image)
{
    Eigen::Vector2f sum(0, 0);
    float count = 0.0f;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const Eigen::Vector3i color = pixelAt(image, x, y);
            if (color.x() - color.z() <= 35) continue;
            sum += Eigen::Vector2f(float(x) / float(image.width) - 0.5f, float(y) / float(image.height) - 0.5f);
            count += 1.0f;
        }
    return count == 0.0f ? 9.0f : (sum / count).norm();
}

RenderSettings following()
{
    RenderSettings settings = automatic();
    settings.camera.kind = CameraKind::Follow;
    settings.camera.follow = "body 0";
    return settings;
}

TEST(Camera, AFollowingCameraKeepsUpWithWhatIsFast)
{
    Gpu& gpu = sharedGpu();
    const auto worldAt = [](double time) { return redBody(cubeLattice(2, 0.2f), {float(30.0 * time), 0, 0}); };
    Renderer renderer(gpu, worldAt(0), following());
    for (int frame = 0; frame <= 30; ++frame) {
        const StillBuffers buffers(worldAt(frame / 60.0));
        renderer.draw(buffers.view(), frame / 60.0);
        // A quarter of half the picture's height, and it is twice as wide.
        EXPECT_LT(offMiddle(renderer.readImage()), 0.13f) << frame;
    }
}

TEST(Camera, AFollowingCameraAwaitsWhatIsNotThereYet)
{
    Gpu& gpu = sharedGpu();
    const World there = redBody(cubeLattice(2, 0.2f), {3, 1, 0});
    World away = there;
    away.bodies[0].absent = true;
    away.bodies[0].position += awayFrom(away, away.bodies[0]);
    Renderer renderer(gpu, away, following());
    const StillBuffers before(away), after(there);
    renderer.look(before.view(), 0.0);
    renderer.draw(after.view(), 1.0 / 60.0);
    EXPECT_LT(offMiddle(renderer.readImage()), 0.02f);
}

TEST(Camera, SeesShapesThatAreLargerThanTheirParticles)
{
    World world = redBody({{-0.1f, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}, {0, -0.1f, 0}}, {0, 0, 0});
    world.bodyShapes.push_back({.body = 0, .middle = world.bodies[0].restCentre, .radius = 0.4f});
    // The particles stand in a plane.
    EXPECT_NEAR(boundsMargin(world, 10.0f), 0.4f - 0.1f, 1e-5f);
    const Framing framing(drawn(world, automatic()));
    EXPECT_GT(std::min(framing.top, framing.bottom), 2);
    EXPECT_GT(framing.height(), 0.6f);
}

TEST(Extent, HasAPlaneThatIsSeenAsItsGround)
{
    StillWorld still(0.1f);
    still.addBody({Vector3f::Zero()}, {0, 1, 0});
    still.addCollider(ColliderShape::Plane, {0, 0.1f, 0}).visible = false;
    EXPECT_EQ(sceneExtent(still.world).groundCollider, 0u);
    still.addCollider(ColliderShape::Plane, {0, -0.2f, 0});
    still.addCollider(ColliderShape::Plane, {0, 0, 0});
    still.addCollider(ColliderShape::Plane, {0, 0, 0}).visible = false;
    EXPECT_EQ(sceneExtent(still.world).groundCollider, 2u);
    EXPECT_EQ(sceneExtent(still.world).ground, 0.0f);
}

}  // namespace
}  // namespace knuckle::test
