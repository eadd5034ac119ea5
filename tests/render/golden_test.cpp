#include "tests/render/golden.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr float RADIUS = 0.1f;

/// Six cubes at rest and in flight, one of each collider, two cubes that share a particle.
World stage()
{
    StillWorld still(RADIUS);
    still.addGround();
    const auto cube = cubeLattice(3, 2 * RADIUS);
    for (int i = 0; i < 6; ++i) {
        const auto step = static_cast<float>(i);
        const Quaternionf turn(Eigen::AngleAxisf(0.5f * step, Vector3f(1, 2, 3).normalized()));
        still.addBody(cube, {-1.2f + 0.75f * static_cast<float>(i % 3), 0.45f + 0.5f * step, 0.6f - 0.4f * step}, turn,
                      {0, -1.2f * step, 0});
    }
    still.world.particles[13].bodyCount = still.world.particles[26].bodyCount = 2;
    Collider& box = still.addCollider(ColliderShape::Box, {1.6f, 0.3f, 0.0f});
    box.halfExtents = {0.4f, 0.3f, 0.8f};
    box.color = {0.55f, 0.40f, 0.25f};
    still.addCollider(ColliderShape::Sphere, {-1.9f, 0.5f, -0.6f}).radius = 0.5f;
    Collider& capsule = still.addCollider(ColliderShape::Capsule, {0.3f, 0.2f, 1.4f});
    capsule.orientation = Quaternionf(Eigen::AngleAxisf(1.5708f, Vector3f(0.2f, 0, 1).normalized()));
    capsule.radius = 0.2f;
    Collider& unseen = still.addCollider(ColliderShape::Box, {0.0f, 1.0f, 1.8f});
    unseen.visible = false;
    return still.world;
}

RenderSettings small()
{
    RenderSettings settings;
    settings.width = 192;
    settings.height = 108;
    return settings;
}

TEST(Golden, TheDefaultsShowBodiesCollidersAndGround)
{
    expectGolden("body", drawn(stage(), small()));
}

TEST(Golden, ColoursByMaterial)
{
    RenderSettings settings = small();
    settings.colorBy = ColorBy::Material;
    expectGolden("material", drawn(stage(), settings));
}

TEST(Golden, ColoursByParticle)
{
    RenderSettings settings = small();
    settings.colorBy = ColorBy::Particle;
    expectGolden("particle", drawn(stage(), settings));
}

TEST(Golden, ColoursBySpeedWithJointsInRed)
{
    RenderSettings settings = small();
    settings.colorBy = ColorBy::Speed;
    settings.highlightJoints = true;
    expectGolden("speed", drawn(stage(), settings));
}

TEST(Golden, AFixedCameraStandsWhereItIsTold)
{
    RenderSettings settings = lookFrom({-2.5f, 1.2f, 4.0f}, {0, 1.2f, 0}, 192, 108);
    settings.highlightJoints = true;
    expectGolden("fixed", drawn(stage(), settings));
}

TEST(Golden, AnOrbitingCameraHasTurnedAfterFourSeconds)
{
    RenderSettings settings = small();
    settings.camera.kind = CameraKind::Orbit;
    settings.camera.orbitSpeed = 30.0f;
    expectGolden("orbit", drawn(stage(), settings, 4.0));
}

TEST(Golden, AFollowingCameraLooksAtItsObject)
{
    RenderSettings settings = small();
    settings.camera.kind = CameraKind::Follow;
    settings.camera.follow = "body 4";
    expectGolden("follow", drawn(stage(), settings));
}

TEST(Golden, SupersamplingKeepsThePicture)
{
    RenderSettings settings = small();
    settings.antialiasing = 2;
    expectGolden("supersampled", drawn(stage(), settings));
}

TEST(Golden, ATiltedPlaneIsARamp)
{
    World world = stage();
    Collider ramp;
    ramp.orientation = Quaternionf(Eigen::AngleAxisf(-0.35f, Vector3f::UnitZ()));
    ramp.position = {-2.0f, 0.6f, 0.0f};
    ramp.color = {0.35f, 0.45f, 0.55f};
    world.colliders.push_back(ramp);
    expectGolden("ramp", drawn(world, small()));
}

}  // namespace
}  // namespace knuckle::test
