#include "render/frame_input.h"

#include <algorithm>
#include <cmath>

#include "render/overlay/overlay.h"
#include "render/picture/lens_samples.h"
#include "render/picture/render_targets.h"
#include "render/quantities/color_scale.h"
#include "render/spheres/sphere_pass.h"
#include "render/view/bounds_margin.h"
#include "sim/base/angles.h"

namespace knuckle {

namespace {

/// View depth of the depth buffer's 1 [m]; depth is linear in floats, so this can be large.
constexpr float FAR_DEPTH = 20000.0f;
/// Where the ground has mostly become the horizon, in sizes of the scene: a plain, and the sweep of a studio.
constexpr float FADE = 9.0f, STUDIO_FADE = 2.5f;
/// How far the ground throws light, in sizes of the scene.
constexpr float BOUNCE_REACH = 0.35f;
/// How near a camera may come to a plane, as a share of the scene's size.
constexpr float CLEARANCE = 0.03f;
const Vector3f GROUND_ALBEDO{0.5f, 0.5f, 0.5f};

gpu::vec4 vec4Of(const Vector3f& v, float w = 0.0f)
{
    return {v.x(), v.y(), v.z(), w};
}

/// The mean of what the ground shows.
Vector3f groundColor(const World& world, const SceneExtent& extent)
{
    if (extent.groundCollider == NO_INDEX) return Vector3f::Zero();
    const Collider& ground = world.colliders[extent.groundCollider];
    // As shaders/render/colliders/floor_looks.glsl tints them.
    const Vector3f tint = ground.floor == FloorLook::Wood      ? Vector3f(1.0f, 0.72f, 0.47f)
                          : ground.floor == FloorLook::Grass   ? Vector3f(0.39f, 0.58f, 0.18f)
                          : ground.floor == FloorLook::Checker ? Vector3f::Constant(0.62f)
                                                               : Vector3f::Ones();
    return ground.color.cwiseProduct(tint);
}

}  // namespace

gpu::FrameInput frameInput(const World& world, const RenderSettings& settings, const SceneExtent& extent)
{
    gpu::FrameInput input{};
    const LightSettings& light = settings.light;
    input.keyDirection = vec4Of(light.direction.normalized(), std::tan(light.softness * DEGREE));
    input.keyColor = vec4Of(light.color * light.intensity, settings.skinError);
    input.skyColor = vec4Of(light.skyColor);
    input.groundColor = vec4Of(light.groundColor, settings.exposure);
    input.groundAlbedo = vec4Of(GROUND_ALBEDO, extent.ground);
    input.backdrop = vec4Of(settings.backgroundColor, BOUNCE_REACH * extent.size);
    input.bounce = vec4Of(groundColor(world, extent), light.bounce);
    input.shadowLimitLow = vec4Of(extent.limit.min());
    input.shadowLimitHigh = vec4Of(extent.limit.max());
    input.solidLow = vec4Of(extent.solids.min());
    input.solidHigh = vec4Of(extent.solids.max());
    input.fog = vec4Of(settings.fog.color, settings.fog.density);
    input.develop = {1.0f / static_cast<float>(drawsOf(settings)), settings.bloom, settings.vignette,
                     settings.fog.falloff};
    const DrawnSize size = drawnSize(settings);
    input.width = size.width * settings.antialiasing;
    input.height = size.height * settings.antialiasing;
    input.particleCount = static_cast<uint32_t>(world.particles.size());
    input.farDepth = FAR_DEPTH;
    input.pointSizeLimit = pointSizeLimit();
    const ColorScale scale = colorScaleOf(world, settings);
    input.speedScale = scale.high - scale.low;
    input.shadowSize = static_cast<float>(shadowSize(settings));
    input.occlusionRadius = std::clamp(0.05f * extent.size, 4.0f * world.particleRadius, 14.0f * world.particleRadius);
    input.patternScale = roundLength(0.25f * extent.size);
    const bool isStudio = extent.groundCollider != NO_INDEX &&
                          world.colliders[extent.groundCollider].floor == FloorLook::Studio;
    input.groundFade = (isStudio ? STUDIO_FADE : FADE) * extent.size;
    input.resolveFactor = settings.antialiasing;
    input.cameraClearance = CLEARANCE * extent.size;
    input.boundsMargin = boundsMargin(world, extent.size);
    return input;
}

void describeParticles(gpu::FrameInput& input, const ParticleView& view, bool hasSurfaces)
{
    input.radius = view.radius;
    input.solidCount = std::min(view.solidCount, view.particleCount);
    input.fluidRadius = (hasSurfaces ? SURFACE_RADIUS : FLUID_RADIUS) * view.fluidSpacing;
    input.fluidSpace = static_cast<uint32_t>(
        std::round(static_cast<float>(SPACE_UNITS) * std::pow(0.5f * view.fluidSpacing / view.radius, 3.0f)));
}

void placeCamera(gpu::FrameInput& input, const Camera& camera, const CameraAim& aim, float passed)
{
    input.cameraPosition = vec4Of(aim.position, camera.followedAway().x());
    input.cameraTarget = vec4Of(aim.target, camera.followedAway().y());
    input.cameraTurn = vec4Of(aim.turn);
    input.cameraMode = camera.mode();
    input.followedBodyStart = camera.followed().start;
    input.followedBodyCount = camera.followed().count;
    input.tanHalfFov = aim.tanHalfFov;
    input.frameShare = camera.settings().fill;
    input.trackSeconds = passed;
    input.focusDistance = camera.settings().focused.empty() ? aim.focus : 0.0f;
}

void placeLens(gpu::FrameInput& input, const RenderSettings& settings, const CameraAim& aim, uint32_t draw)
{
    const LensSample sample = lensSample(draw, drawsOf(settings));
    const DrawnSize size = drawnSize(settings);
    input.lens = {2.0f * sample.pixelX / static_cast<float>(size.width),
                  2.0f * sample.pixelY / static_cast<float>(size.height), 0.5f * aim.aperture * sample.lensX,
                  0.5f * aim.aperture * sample.lensY};
}

}  // namespace knuckle
