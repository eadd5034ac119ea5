#include <algorithm>
#include <cmath>
#include <cstring>

#include "shared/frame_types.h"
#include "sim/base/angles.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float RADIUS = 0.05f, FRAME = 1.0f / 60.0f;

/// The view that a renderer's camera has.
gpu::FrameView viewOf(const Renderer& renderer)
{
    const std::vector<std::byte> bytes = renderer.saveState().buffers.at("view");
    gpu::FrameView view{};
    EXPECT_EQ(bytes.size(), sizeof(view));
    std::memcpy(&view, bytes.data(), sizeof(view));
    return view;
}

Vector3f vectorOf(const gpu::vec4& v)
{
    return {v.x, v.y, v.z};
}

/// Where spheres are in a picture: -1 ... 1 across it and upwards.
struct Seen {
    Eigen::AlignedBox2f box;

    Seen(const gpu::FrameView& view, const RenderSettings& settings, const std::vector<Vector3f>& centres)
    {
        const float slope = std::tan(0.5f * settings.camera.fieldOfView * DEGREE);
        const Eigen::Array2f scale(slope * float(settings.width) / float(settings.height), slope);
        for (const Vector3f& centre : centres) {
            const Vector3f arm = centre - vectorOf(view.cameraPosition);
            const float depth = -arm.dot(vectorOf(view.cameraBack));
            EXPECT_GT(depth, RADIUS);
            const Eigen::Array2f place(arm.dot(vectorOf(view.cameraRight)), arm.dot(vectorOf(view.cameraUp)));
            box.extend(((place - RADIUS) / (scale * depth)).matrix());
            box.extend(((place + RADIUS) / (scale * depth)).matrix());
        }
    }
    bool isWhole() const { return box.min().minCoeff() >= -1 && box.max().maxCoeff() <= 1; }
    /// The larger of the shares of width and height that they fill.
    float share() const { return 0.5f * box.sizes().maxCoeff(); }
};

/// A figure of 1.7 m and a crate that it leaves behind.
struct Stage {
    static constexpr uint32_t FIGURE = 72;
    std::vector<Vector3f> offsets;

    Stage()
    {
        for (uint32_t i = 0; i < FIGURE; ++i)
            offsets.emplace_back(0.5f * float(i % 2) - 0.25f, 0.1f * float(i / 4) - 0.85f, 0.3f * float(i / 2 % 2));
    }
    /// It stands at `place`, leaning by `lean` [rad].
    World at(const Vector3f& place, float lean) const
    {
        StillWorld still(RADIUS);
        still.addGround();
        still.addBody(offsets, place, Quaternionf(Eigen::AngleAxisf(lean, Vector3f::UnitZ())));
        still.addBody({Vector3f::Zero()}, {-4, 0.05f, -3});
        return still.world;
    }
    RenderSettings framing(const Vector3f& from) const
    {
        RenderSettings settings = lookFrom(from, {0, 1, 0}, 160, 90);
        settings.camera.attention = CameraAttention::Frame;
        settings.camera.named = {{0, FIGURE}};
        settings.camera.fill = 0.7f;
        return settings;
    }
    std::vector<Vector3f> centres(const World& world) const
    {
        std::vector<Vector3f> centres;
        for (uint32_t i = 0; i < FIGURE; ++i) centres.push_back(world.particles[i].position);
        return centres;
    }
};

/// From 0 to 1 within a time, beginning and ending at rest.
float eased(float time, float begin, float end)
{
    const float t = std::clamp((time - begin) / (end - begin), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// Runs as fast as 6 m/s, leaps, falls and lies within two seconds.
std::pair<Vector3f, float> leap(float time)
{
    const float run = 5.0f * eased(time, 0.0f, 1.3f), fall = eased(time, 0.9f, 1.3f);
    const float rise = 1.2f * (eased(time, 0.4f, 0.8f) - fall);
    return {Vector3f(run, 0.9f + rise - 0.6f * fall, 0.5f * run), 1.5f * fall};
}

TEST(FramingCamera, KeepsObjectsWholeAndLargeAsTheyLeapAndFall)
{
    Gpu& gpu = sharedGpu();
    const Stage stage;
    const World world = stage.at({0, 1, 0}, 0);
    for (const Vector3f& from : {Vector3f(0.5f, 2, 6), Vector3f(6, 1.5f, 0.5f), Vector3f(3, 4, 5)}) {
        const RenderSettings settings = stage.framing(from);
        Renderer renderer(gpu, world, settings);
        Vector3f before = Vector3f::Zero(), speedBefore = Vector3f::Zero();
        for (int frame = 0; frame < 150; ++frame) {
            const auto [place, lean] = leap(float(frame) * FRAME);
            const World now = stage.at(place, lean);
            const StillBuffers buffers(now);
            renderer.look(buffers.view(), frame / 60.0);
            const gpu::FrameView view = viewOf(renderer);
            const Seen seen(view, settings, stage.centres(now));
            EXPECT_TRUE(seen.isWhole()) << from.transpose() << ", frame " << frame << ": " << seen.box.min().transpose()
                                        << " to " << seen.box.max().transpose();
            EXPECT_GT(seen.share(), 1.0f / 3) << from.transpose() << ", frame " << frame;
            const Vector3f eye = vectorOf(view.cameraPosition), speed = (eye - before) / FRAME;
            // As it falls within 0.4 s, its own speed changes by 1.3 m/s in a frame, and its height as fast.
            if (frame > 2) {
                EXPECT_LT((speed - speedBefore).norm(), 2.0f) << from.transpose() << ", frame " << frame;
            }
            before = eye;
            speedBefore = speed;
        }
    }
}

TEST(FramingCamera, NeverGoesBelowTheFloor)
{
    Gpu& gpu = sharedGpu();
    const Stage stage;
    for (const float height : {0.9f, 0.3f}) {
        const World world = stage.at({0, height, 0}, height < 0.5f ? 1.57f : 0.0f);
        const StillBuffers buffers(world);
        for (const Vector3f& from : {Vector3f(0, -3, 6), Vector3f(5, 0.5f, 0), Vector3f(0, -9, 1)}) {
            const RenderSettings settings = stage.framing(from);
            Renderer renderer(gpu, world, settings);
            renderer.look(buffers.view(), 0.0);
            const gpu::FrameView view = viewOf(renderer);
            // 3 % of the stage, whose largest side is more than the 4 m to the crate.
            EXPECT_GT(view.cameraPosition.y, 0.1f) << from.transpose();
            const Seen seen(view, settings, stage.centres(world));
            EXPECT_TRUE(seen.isWhole()) << from.transpose();
            EXPECT_GT(seen.share(), 1.0f / 3) << from.transpose();
        }
    }
}

TEST(FramingCamera, LooksAtTheMiddleFromWhereItStands)
{
    Gpu& gpu = sharedGpu();
    const Stage stage;
    const World world = stage.at({2, 1, 0}, 0);
    const StillBuffers buffers(world);
    RenderSettings settings = stage.framing({0.5f, 2, 6});
    settings.camera.attention = CameraAttention::LookAt;
    Renderer renderer(gpu, world, settings);
    renderer.look(buffers.view(), 0.0);
    const gpu::FrameView view = viewOf(renderer);
    EXPECT_NEAR((vectorOf(view.cameraPosition) - settings.camera.position).norm(), 0, 1e-6f);
    const Vector3f middle(2, 1, 0.15f), back = (settings.camera.position - middle).normalized();
    EXPECT_NEAR((vectorOf(view.cameraBack) - back).norm(), 0, 1e-5f);
}

TEST(ShotCamera, RollsPansAndTilts)
{
    Gpu& gpu = sharedGpu();
    const World world = Stage().at({0, 1, 0}, 0);
    const StillBuffers buffers(world);
    RenderSettings settings = lookFrom({0, 1, 6}, {0, 1, 0}, 160, 90);
    settings.camera.roll = 90;
    Renderer renderer(gpu, world, settings);
    renderer.look(buffers.view(), 0.0);
    EXPECT_NEAR((vectorOf(viewOf(renderer).cameraRight) - Vector3f::UnitY()).norm(), 0, 1e-6f);
    EXPECT_NEAR((vectorOf(viewOf(renderer).cameraUp) + Vector3f::UnitX()).norm(), 0, 1e-6f);
    settings.camera.roll = 0;
    settings.camera.shake = {.amplitude = 3};
    Renderer shaken(gpu, world, settings);
    shaken.look(buffers.view(), 0.4);
    const gpu::FrameView view = viewOf(shaken);
    const float turned = std::acos(vectorOf(view.cameraBack).z());
    EXPECT_GT(turned, 0.1f * DEGREE);
    EXPECT_LT(turned, std::sqrt(2.0f) * 3 * DEGREE);
    EXPECT_NEAR(vectorOf(view.cameraRight).dot(vectorOf(view.cameraUp)), 0, 1e-6f);
}

/// The frame of a cut is the new camera's, as if it were its first; the frame before is the old one's.
TEST(ShotCamera, CutsAtTheFrame)
{
    Gpu& gpu = sharedGpu();
    const Stage stage;
    const World world = stage.at({0, 1, 0}, 0), later = stage.at({2, 1, 0}, 0);
    const StillBuffers first(world), second(later);
    const RenderSettings one = stage.framing({0.5f, 2, 6}), other = stage.framing({6, 2, 0.5f});
    RenderSettings both = one;
    both.shots = {{.from = 0, .camera = one.camera}, {.from = 0.5, .camera = other.camera}};
    const auto picture = [&](Renderer& renderer, const StillBuffers& buffers, int frame) {
        renderer.draw(buffers.view(), frame / 60.0);
        return renderer.readImage().rgb;
    };
    Renderer film(gpu, world, both), before(gpu, world, one), after(gpu, world, other);
    film.look(first.view(), 28 / 60.0);
    before.look(first.view(), 28 / 60.0);
    EXPECT_TRUE(picture(film, second, 29) == picture(before, second, 29));
    EXPECT_TRUE(picture(film, second, 30) == picture(after, second, 30));
    EXPECT_TRUE(picture(film, first, 31) == picture(after, first, 31)) << "goes on from the cut";
}

}  // namespace
}  // namespace knuckle::test
