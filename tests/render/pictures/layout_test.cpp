#include "render/panes/layout.h"

#include <algorithm>

#include "sim/base/errors.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

World cubeOnTheGround()
{
    StillWorld still(0.1f);
    still.addGround();
    still.addBody(cubeLattice(3, 0.2f), {0.2f, 0.3f, 0});
    return still.world;
}

/// A shot in which a camera shares the picture with another one.
RenderSettings shared(PictureLayout layout, uint32_t width, uint32_t height)
{
    RenderSettings settings = lookFrom({0, 1, 3}, {0, 0.3f, 0}, width, height);
    Shot shot{.camera = settings.camera, .layout = layout, .other = settings.camera};
    shot.other.position = {2, 1, 0};
    shot.other.roll = 20.0f;
    settings.shots = {shot};
    return settings;
}

/// What one camera sees alone.
Image alone(const CameraSettings& camera, uint32_t width, uint32_t height, uint32_t depth = 8)
{
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.camera = camera;
    settings.depth = depth;
    return drawn(cubeOnTheGround(), settings);
}

/// Expects a part of an image to have all bits of another one, but for columns before `from` and after `to`.
void expectPart(const Image& image, const Image& part, uint32_t left, uint32_t top, uint32_t from, uint32_t to)
{
    size_t different = 0;
    for (uint32_t y = 0; y < part.height; ++y)
        for (uint32_t x = from; x < to; ++x) {
            const size_t own = 3 * (size_t(y) * part.width + x), there = 3 * (size_t(top + y) * image.width + left + x);
            for (size_t c = 0; c < 3; ++c) {
                different += part.rgb[own + c] != image.rgb[there + c];
                if (!image.deep.empty()) different += part.deep[own + c] != image.deep[there + c];
            }
        }
    EXPECT_EQ(different, 0u);
}

TEST(PictureLayouts, BesideGivesEachCameraAHalf)
{
    // An odd width: the left half has the column more.
    RenderSettings settings = shared(PictureLayout::Beside, 97, 54);
    settings.depth = 16;
    const Image image = drawn(cubeOnTheGround(), settings);
    ASSERT_EQ(image.width, 97u);
    ASSERT_EQ(image.deep.size(), image.rgb.size());
    // A line of one pixel is the last column of the left half.
    expectPart(image, alone(settings.shots[0].camera, 49, 54, 16), 0, 0, 0, 48);
    expectPart(image, alone(settings.shots[0].other, 48, 54, 16), 49, 0, 0, 48);
    for (const uint32_t y : {0u, 30u, 53u}) EXPECT_EQ(pixelAt(image, 48, y), Eigen::Vector3i(255, 255, 255));
}

TEST(PictureLayouts, AnInsetStandsInItsCornerAThirdAsLarge)
{
    RenderSettings settings = shared(PictureLayout::Inset, 96, 54);
    const Image own = alone(settings.camera, 96, 54), small = alone(settings.shots[0].other, 32, 18);
    // 0.04 of the height are two pixels away from both edges.
    struct Place {
        Corner corner;
        uint32_t left, top;
    };
    for (const auto& [corner, left, top] : {Place{Corner::BottomRight, 62, 34},
                                            {Corner::BottomLeft, 2, 34},
                                            {Corner::TopRight, 62, 2},
                                            {Corner::TopLeft, 2, 2}}) {
        settings.shots[0].insetAt = corner;
        const Image image = drawn(cubeOnTheGround(), settings);
        expectPart(image, small, left, top, 0, 32);
        EXPECT_EQ(pixelAt(image, left - 1, top - 1), Eigen::Vector3i(255, 255, 255));
        EXPECT_EQ(pixelAt(image, left + 32, top + 18), Eigen::Vector3i(255, 255, 255));
        for (uint32_t y = 0; y < 54; ++y)
            for (uint32_t x = 0; x < 96; ++x)
                if (x + 1 < left || x > left + 32 || y + 1 < top || y > top + 18) {
                    ASSERT_EQ(pixelAt(image, x, y), pixelAt(own, x, y)) << x << " " << y;
                }
    }
}

TEST(PictureLayouts, ChangeWithTheShots)
{
    RenderSettings settings = shared(PictureLayout::Beside, 96, 54);
    settings.shots.push_back({.from = 1.0, .camera = settings.camera});
    const World world = cubeOnTheGround();
    const StillBuffers buffers(world);
    Renderer renderer(sharedGpu(), world, settings);
    renderer.draw(buffers.view(), 0.0);
    const Image first = renderer.readImage();
    renderer.draw(buffers.view(), 1.0);
    EXPECT_EQ(renderer.readImage().rgb, alone(settings.camera, 96, 54).rgb);
    renderer.draw(buffers.view(), 0.5);
    EXPECT_EQ(renderer.readImage().rgb, first.rgb);
    // What each part carries on has its own name.
    const RendererState state = renderer.saveState();
    for (const char* name : {"view", "left/view", "right/view"}) EXPECT_TRUE(state.buffers.contains(name)) << name;
    RendererState other = state;
    other.buffers["inset/view"] = other.buffers["view"];
    EXPECT_THROW(renderer.loadState(other), std::logic_error);
    other = state;
    other.buffers.erase("right/view");
    EXPECT_THROW(renderer.loadState(other), std::logic_error);
    EXPECT_EQ(renderer.saveState().buffers, state.buffers);
}

TEST(PictureLayouts, NeedRoom)
{
    const World world = cubeOnTheGround();
    std::string told;
    try {
        const Renderer renderer(sharedGpu(), world, shared(PictureLayout::Inset, 64, 36));
    } catch (const InputError& error) {
        told = error.what();
    }
    EXPECT_EQ(told,
              "shots: a part of 21 x 12 pixels is too small; take a larger picture, or leave out `inset` and `beside`");
}

}  // namespace
}  // namespace knuckle::test
