#include <algorithm>
#include <cstring>

#include "shared/frame_types.h"
#include "sim/world/collider_distance.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float FRAME = 1.0f / 60.0f;

Vector3f eyeOf(const Renderer& renderer)
{
    gpu::FrameView view{};
    const std::vector<std::byte> bytes = renderer.saveState().buffers.at("view");
    std::memcpy(&view, bytes.data(), sizeof(view));
    return {view.cameraPosition.x, view.cameraPosition.y, view.cameraPosition.z};
}

/// Distances to a ball of a radius, as a mesh's grid has them.
ColliderGrid ballGrid(float radius)
{
    ColliderGrid grid;
    grid.counts = {33, 33, 33};
    grid.cell = Vector3f::Constant(4.0f * radius / 32.0f);
    grid.low = Vector3f::Constant(-2.0f * radius);
    for (int z = 0; z < 33; ++z)
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 33; ++x) {
                const Vector3f p = grid.low + grid.cell.cwiseProduct(Eigen::Vector3i(x, y, z).cast<float>());
                grid.values.push_back(p.norm() - radius);
            }
    grid.vertices = {{-radius, 0, 0}, {radius, 0, 0}, {0, radius, 0}};
    grid.triangles = {{0, 1, 2}};
    grid.findBounds();
    return grid;
}

/// A field with a hill in its middle.
ColliderGrid hill()
{
    std::vector<float> heights;
    for (int z = 0; z < 33; ++z)
        for (int x = 0; x < 33; ++x) {
            const Eigen::Vector2f p(0.25f * float(x - 16), 0.25f * float(z - 16));
            heights.push_back(2.5f * std::exp(-p.squaredNorm()));
        }
    return makeHeightfield({8, 8}, 33, 33, std::move(heights));
}

/// A small cube, and an obstacle of a shape at `place`.
World obstructed(ColliderShape shape, const Vector3f& cube, const Vector3f& place)
{
    StillWorld still(0.1f);
    still.addBody(cubeLattice(2, 0.2f), cube);
    if (shape == ColliderShape::Mesh) still.world.colliderGrids.push_back(ballGrid(0.8f));
    if (shape == ColliderShape::Heightfield) still.world.colliderGrids.push_back(hill());
    Collider& collider = still.addCollider(shape, place);
    if (!still.world.colliderGrids.empty()) collider.grid = 0;
    collider.orientation = Eigen::AngleAxisf(shape == ColliderShape::Heightfield ? 0.0f : 0.5f, Vector3f::UnitX());
    collider.halfExtents = {0.6f, 1.5f, 0.4f};
    collider.radius = 0.7f;
    collider.halfHeight = 0.5f;
    return still.world;
}

RenderSettings watching(CameraKind kind)
{
    RenderSettings settings = lookFrom({0, 0.5f, 4}, {0, 0, 0}, 64, 36);
    settings.camera.kind = kind;
    settings.camera.follow = "body 0";
    if (kind != CameraKind::Follow) {
        settings.camera.attention = CameraAttention::Frame;
        settings.camera.named = {{0, 8}};
    }
    return settings;
}

struct Way {
    float nearest = 1e9f;  ///< To the obstacle, of the camera [m].
    float jump = 0.0f;     ///< The longest way of it within a frame.
    float last = 0.0f;     ///< How far it is from the cube at the end.
};

/// Films three seconds. @param worldAt what there is at a share of them.
Way filmed(CameraKind kind, const std::function<World(float)>& worldAt)
{
    Gpu& gpu = sharedGpu();
    const World first = worldAt(0.0f);
    Renderer renderer(gpu, first, watching(kind));
    Way way;
    Vector3f before(0, 0, 0);
    for (int frame = 0; frame <= 180; ++frame) {
        const World world = worldAt(static_cast<float>(frame) / 180.0f);
        const StillBuffers buffers(world);
        renderer.look(buffers.view(), FRAME * static_cast<float>(frame));
        const Vector3f eye = eyeOf(renderer);
        way.nearest = std::min(way.nearest, colliderDistance(world, world.colliders[0], eye));
        if (frame > 0) way.jump = std::max(way.jump, (eye - before).norm());
        before = eye;
        way.last = (eye - world.bodies[0].position).norm();
    }
    EXPECT_NO_THROW(gpu.checkErrors());
    return way;
}

constexpr std::array SHAPES{ColliderShape::Box, ColliderShape::Sphere, ColliderShape::Capsule, ColliderShape::Mesh,
                            ColliderShape::Heightfield};

/// The cube passes in front of the obstacle, 2 m a second; the camera 4 m behind it would go through that.
TEST(CameraSolids, HoldOffACameraThatWouldGoThroughThem)
{
    for (const CameraKind kind : {CameraKind::Follow, CameraKind::Fixed})
        for (const ColliderShape shape : SHAPES) {
            const bool ground = shape == ColliderShape::Heightfield;
            const float z = kind == CameraKind::Follow ? 4.0f : 2.0f;
            const Way way = filmed(kind, [&](float share) {
                return obstructed(shape, {-3.0f + 6.0f * share, ground ? 1.0f : 0.0f, 0.0f}, {0, 0, z});
            });
            // The eye is 0.04 of its distance away from it, which is at least a metre here.
            EXPECT_GT(way.nearest, 0.03f) << int(kind) << " " << int(shape);
            EXPECT_LT(way.nearest, 0.8f) << int(kind) << " " << int(shape) << ": it comes near";
            // It gives way by 3 m at most within the 0.16 of 4 m that the cube passes at 2 m/s, on a smooth step, whose
            // greatest slope is 1.5: 14 m/s, a quarter of a metre a frame, and the cube's own way.
            EXPECT_LT(way.jump, 0.3f) << int(kind) << " " << int(shape);
        }
}

TEST(CameraSolids, ThatMoveHoldItOffAsWell)
{
    for (const ColliderShape shape : {ColliderShape::Box, ColliderShape::Mesh}) {
        const Way way = filmed(CameraKind::Follow, [&](float share) {
            return obstructed(shape, {0, 0, 0}, {-3.0f + 6.0f * share, 0.5f, 4.0f});
        });
        EXPECT_GT(way.nearest, 0.03f) << int(shape);
        EXPECT_LT(way.jump, 0.3f) << int(shape);
        EXPECT_NEAR(way.last, Vector3f(0, 0.5f, 4).norm(), 1e-3f) << int(shape) << ": it is where it was meant to be";
    }
}

TEST(CameraSolids, UnderTheCubeOrUnseenDoNotMind)
{
    const World floor = obstructed(ColliderShape::Box, {0, 1.71f, 0}, {0, 0, 0});
    World unseen = obstructed(ColliderShape::Box, {0, 0, 0}, {0, 0, 3});
    unseen.colliders[0].visible = false;
    for (World world : {floor, unseen}) {
        if (world.colliders[0].visible) {
            world.colliders[0].orientation.setIdentity();
            world.colliders[0].halfExtents = {9, 1.5f, 9};
        }
        const Way way = filmed(CameraKind::Follow, [&](float) { return world; });
        // 0.5 m up over 4 m is 0.12 of the way, as far as it is from the floor less: it comes a little nearer.
        EXPECT_GT(way.last, 2.0f);
        if (!world.colliders[0].visible) {
            EXPECT_NEAR(way.last, Vector3f(0, 0.5f, 4).norm(), 1e-3f);
        }
    }
}

/// A cube beside a wall that is much larger, with a camera that is meant to stand behind that.
TEST(CameraSolids, AreGoneAroundWhereTheyHideWhatItLooksAt)
{
    for (const CameraKind kind : {CameraKind::Follow, CameraKind::Fixed}) {
        const float z = kind == CameraKind::Follow ? 0.8f : 0.4f;
        World world = obstructed(ColliderShape::Box, {0, 0, 0}, {0, 0, z});
        world.colliders[0].orientation.setIdentity();
        world.colliders[0].halfExtents = {3, 3, 0.1f};
        RenderSettings settings = watching(kind);
        Renderer renderer(sharedGpu(), world, settings);
        const StillBuffers buffers(world);
        renderer.look(buffers.view(), 0.0);
        const Vector3f eye = eyeOf(renderer);
        for (float share = 0.05f; share <= 1.0f; share += 0.05f)
            EXPECT_GT(colliderDistance(world, world.colliders[0], share * eye), 0.0f) << int(kind) << " " << share;
        // A cube of 0.4 m fills 0.85 of the height from 0.85 m away.
        const float least = kind == CameraKind::Follow ? 0.85f * Vector3f(0, 0.5f, 4).norm() : 0.8f;
        EXPECT_GT(eye.norm(), least) << int(kind);
    }
}

}  // namespace
}  // namespace knuckle::test
