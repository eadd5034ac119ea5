#include "render/settings.h"

#include <fmt/format.h>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

void requireRange(double value, double low, double high, const char* field)
{
    if (value >= low && value <= high) return;
    throw InputError(fmt::format("{}: {} is outside {} ... {}", field, value, low, high));
}

}  // namespace

void checkSettings(const RenderSettings& settings)
{
    requireRange(settings.width, 16, 8192, "render.width");
    requireRange(settings.height, 16, 8192, "render.height");
    requireRange(settings.antialiasing, 1, 4, "render.antialiasing");
    requireRange(settings.skinOpacity, 0, 1, "render.skinOpacity");
    requireRange(settings.skinError, 0, 100, "render.skinError");
    requireRange(settings.exposure, 0.01, 100, "render.exposure");
    requireRange(settings.speedScale, 1e-6, 1e6, "render.speedScale");
    requireRange(settings.light.intensity, 0, 20, "light.intensity");
    requireRange(settings.light.softness, 0, 20, "light.softness");
    requireRange(settings.camera.fieldOfView, 5, 120, "camera.fieldOfView");
    if (!(settings.light.direction.norm() > 1e-6f))
        throw InputError("light.direction: it has no length; point it towards the light");
}

}  // namespace knuckle
