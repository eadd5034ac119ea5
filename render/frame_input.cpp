#include "render/frame_input.h"

#include <algorithm>
#include <cmath>

#include "render/picture/render_targets.h"
#include "render/spheres/sphere_pass.h"
#include "sim/base/angles.h"

namespace knuckle {

namespace {

/// View depth of the depth buffer's 1 [m]; depth is linear in floats, so this can be large.
constexpr float FAR_DEPTH = 20000.0f;
/// How near a camera may come to a plane, as a share of the scene's size.
constexpr float CLEARANCE = 0.03f;
const Vector3f KEY_TINT{1.0f, 0.955f, 0.89f};
const Vector3f GROUND_ALBEDO{0.5f, 0.5f, 0.5f};

gpu::vec4 vec4Of(const Vector3f& v, float w = 0.0f)
{
    return {v.x(), v.y(), v.z(), w};
}

/// 1, 2 or 5 times a power of ten, at most `size`.
float roundLength(float size)
{
    const float power = std::pow(10.0f, std::floor(std::log10(size)));
    return power * (size >= 5.0f * power ? 5.0f : size >= 2.0f * power ? 2.0f : 1.0f);
}

}  // namespace

gpu::FrameInput frameInput(const World& world, const RenderSettings& settings, const SceneExtent& extent)
{
    gpu::FrameInput input{};
    const LightSettings& light = settings.light;
    input.keyDirection = vec4Of(light.direction.normalized(), std::tan(light.softness * DEGREE));
    input.keyColor = vec4Of(KEY_TINT * light.intensity, settings.skinError);
    input.skyColor = vec4Of(light.skyColor);
    input.groundColor = vec4Of(light.groundColor, settings.exposure);
    input.groundAlbedo = vec4Of(GROUND_ALBEDO, extent.ground);
    input.shadowLimitLow = vec4Of(extent.limit.min());
    input.shadowLimitHigh = vec4Of(extent.limit.max());
    input.solidLow = vec4Of(extent.solids.min());
    input.solidHigh = vec4Of(extent.solids.max());
    input.width = settings.width * settings.antialiasing;
    input.height = settings.height * settings.antialiasing;
    input.particleCount = static_cast<uint32_t>(world.particles.size());
    input.farDepth = FAR_DEPTH;
    input.pointSizeLimit = pointSizeLimit();
    input.speedScale = settings.speedScale;
    input.shadowSize = static_cast<float>(SHADOW_SIZE);
    input.occlusionRadius = std::clamp(0.05f * extent.size, 4.0f * world.particleRadius, 14.0f * world.particleRadius);
    input.patternScale = roundLength(0.25f * extent.size);
    input.groundFade = 9.0f * extent.size;
    input.resolveFactor = settings.antialiasing;
    input.cameraClearance = CLEARANCE * extent.size;
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

void placeCamera(gpu::FrameInput& input, const Camera& camera, double time, float passed)
{
    const CameraAim aim = camera.at(time);
    input.cameraPosition = vec4Of(aim.position);
    input.cameraTarget = vec4Of(aim.target);
    input.cameraTurn = vec4Of(aim.turn);
    input.cameraMode = camera.mode();
    input.followedBodyStart = camera.followed().start;
    input.followedBodyCount = camera.followed().count;
    input.tanHalfFov = aim.tanHalfFov;
    input.frameShare = camera.settings().fill;
    input.trackSeconds = passed;
}

}  // namespace knuckle
