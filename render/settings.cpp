#include "render/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

void requireRange(double value, double low, double high, const char* field)
{
    if (value >= low && value <= high) return;
    throw InputError(fmt::format("{}: {} is outside {} ... {}", field, value, low, high));
}

void checkCamera(const CameraSettings& camera)
{
    requireRange(camera.fieldOfView, 5, 120, "camera.fieldOfView");
    requireRange(camera.roll, -360, 360, "camera.roll");
    requireRange(camera.fill, 0.2, 1, "camera.fill");
    requireRange(camera.shake.amplitude, 0, 20, "camera.shake.amplitude");
    requireRange(camera.shake.frequency, 0.01, 20, "camera.shake.frequency");
    requireRange(camera.aperture, 0, 100, "camera.aperture");
    requireRange(camera.focus, 0, 1e5, "camera.focus");
    for (const CameraKey& key : camera.keys) {
        requireRange(key.fieldOfView, 5, 120, "camera.keys.fieldOfView");
        requireRange(key.aperture, 0, 100, "camera.keys.aperture");
        requireRange(key.focus, 0, 1e5, "camera.keys.focus");
    }
}

/// Whether a camera has a lens that blurs.
bool hasAperture(const CameraSettings& camera)
{
    return camera.aperture > 0.0f ||
           std::ranges::any_of(camera.keys, [](const CameraKey& key) { return key.aperture > 0.0f; });
}

/// Whether a frame takes several draws because of what is not sharp in it.
bool isBlurred(const RenderSettings& settings)
{
    return settings.shutter > 0.0f || hasAperture(settings.camera) ||
           std::ranges::any_of(settings.shots, [](const Shot& shot) {
               return hasAperture(shot.camera) || (shot.layout != PictureLayout::One && hasAperture(shot.other));
           });
}

void checkLens(const RenderSettings& settings)
{
    requireRange(settings.samples, 0, MOST_SAMPLES, "render.samples");
    requireRange(settings.shutter, 0, 360, "render.shutter");
    requireRange(settings.bloom, 0, 1, "render.bloom");
    requireRange(settings.vignette, 0, 1, "render.vignette");
    requireRange(settings.fog.density, 0, 100, "render.fog.density");
    requireRange(settings.fog.falloff, 0, 100, "render.fog.falloff");
    if (settings.samples == 1 && isBlurred(settings))
        throw InputError(
            "render.samples: 1 draw blurs nothing, and there is a shutter or an aperture; take 2 to 64, or 0 "
            "for as many as they need");
}

}  // namespace

size_t shotAt(const std::vector<Shot>& shots, double time)
{
    constexpr double ROUNDING = 1e-6;  // a frame at the time of a cut is the new shot's first, [s]
    const auto next = std::ranges::find_if(shots, [&](const Shot& shot) { return shot.from > time + ROUNDING; });
    return static_cast<size_t>(std::max<std::ptrdiff_t>(next - shots.begin() - 1, 0));
}

RenderSettings filmedBy(const RenderSettings& settings, const std::string& camera)
{
    RenderSettings filmed = settings;
    filmed.camera = settings.cameras.at(camera);
    for (Shot& shot : filmed.shots) {
        shot.camera = filmed.camera;
        shot.layout = PictureLayout::One;
    }
    return filmed;
}

void checkSettings(const RenderSettings& settings)
{
    requireRange(settings.width, 16, 8192, "render.width");
    requireRange(settings.height, 16, 8192, "render.height");
    requireRange(settings.antialiasing, 1, 4, "render.antialiasing");
    requireRange(static_cast<double>(settings.lights.size()), 0, LIGHT_SOURCES, "lights");
    if (!settings.light.skyFile.empty() && settings.light.sky == nullptr)
        throw std::logic_error("the picture of the sky has not been read");
    requireRange(settings.skinOpacity, 0, 1, "render.skinOpacity");
    requireRange(settings.skinError, 0, 100, "render.skinError");
    requireRange(settings.exposure, 0.01, 100, "render.exposure");
    requireRange(settings.speedScale, 1e-6, 1e6, "render.speedScale");
    if (settings.colorScale && !(settings.colorScale->x() < settings.colorScale->y()))
        throw InputError("render.colorScale: its high end must be above its low one");
    requireRange(settings.light.intensity, 0, 20, "light.intensity");
    requireRange(settings.light.softness, 0, 20, "light.softness");
    checkLens(settings);
    checkCamera(settings.camera);
    for (const Shot& shot : settings.shots) {
        checkCamera(shot.camera);
        checkCamera(shot.other);
    }
    if (!(settings.light.direction.norm() > 1e-6f))
        throw InputError("light.direction: it has no length; point it towards the light");
}

uint32_t drawsOf(const RenderSettings& settings)
{
    constexpr uint32_t OF_BLUR = 16, OF_FINAL = 8;
    if (settings.samples > 0) return settings.samples;
    return isBlurred(settings) ? OF_BLUR : settings.quality == Quality::Final ? OF_FINAL : 1;
}

bool hasLens(const RenderSettings& settings)
{
    return settings.quality == Quality::Final || settings.bloom > 0.0f || settings.vignette > 0.0f ||
           drawsOf(settings) > 1;
}

DrawnSize drawnSize(const RenderSettings& settings)
{
    if (settings.quality != Quality::Draft) return {settings.width, settings.height};
    return {(settings.width + 1) / 2, (settings.height + 1) / 2};
}

}  // namespace knuckle
