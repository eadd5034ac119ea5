#include "render/quantities/color_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "sim/base/colors.h"
#include "sim/world/space/bounds.h"

namespace knuckle {

namespace {

/// sRGB at even places. viridis (S. van der Walt, N. Smith 2015) and cividis (J. Nunez, C. Anderton, R. Renslow 2018,
/// made for eyes without red or green) have even steps of lightness; turbo (A. Mikhailov 2019) tells most values apart;
/// RdBu of C. Brewer 2003, turned, has a pale middle. Blue to red is safe for eyes without red or green.
constexpr std::array VIRIDIS{0x440154u, 0x472d7bu, 0x3b528bu, 0x2c728eu, 0x21918cu,
                             0x28ae80u, 0x5ec962u, 0xaddc30u, 0xfde725u};
constexpr std::array CIVIDIS{0x00224eu, 0x123570u, 0x3b496cu, 0x575d6du, 0x707173u,
                             0x8a8678u, 0xa59c74u, 0xc3b369u, 0xe1cc55u, 0xfee838u};
constexpr std::array TURBO{0x30123bu, 0x4662d7u, 0x36aaf9u, 0x1ae4b6u, 0x72fe5eu,
                           0xc7ef34u, 0xfaba39u, 0xf66b19u, 0xcb2a04u, 0x7a0403u};
constexpr std::array DIVERGING{0x2166acu, 0x4393c3u, 0x92c5deu, 0xd1e5f0u, 0xf7f7f7u,
                               0xfddbc7u, 0xf4a582u, 0xd6604du, 0xb2182bu};
/// As in scale_color.glsl, linear.
const std::array HEAT{Vector3f(0.020f, 0.050f, 0.230f), Vector3f(0.010f, 0.240f, 0.360f),
                      Vector3f(0.120f, 0.480f, 0.160f), Vector3f(0.900f, 0.420f, 0.040f),
                      Vector3f(1.000f, 0.850f, 0.640f)};

constexpr float LEAST_PRESSURE = 1000.0f;  // [Pa]
constexpr float EARTH_GRAVITY = 9.81f;     // [m/s2], for worlds without gravity
constexpr float LEAST_COLUMN = 10.0f;      // [particles]

std::span<const uint32_t> anchorsOf(Palette palette)
{
    switch (palette) {
        case Palette::Cividis: return CIVIDIS;
        case Palette::Turbo: return TURBO;
        case Palette::Diverging: return DIVERGING;
        default: return VIRIDIS;
    }
}

Vector3f rootsOf(uint32_t srgb)
{
    const auto root = [&](int shift) {
        return static_cast<float>(std::sqrt(linearOfSrgb(static_cast<double>(srgb >> shift & 255u) / 255.0)));
    };
    return {root(16), root(8), root(0)};
}

float startingPressure(const World& world)
{
    const Vector3f gravity = world.settings.gravity;
    float low = 0.0f, high = 0.0f, density = 0.0f;
    const size_t end = world.particles.size() - world.pooledCount();
    for (size_t i = world.particles.size() - world.fluidCount; i < end; ++i) {
        const Particle& p = world.particles[i];
        const float depth = p.position.dot(gravity);
        if (density == 0.0f) low = high = depth;
        low = std::min(low, depth);
        high = std::max(high, depth);
        density = std::max(density, world.materials[p.material].density);
    }
    return std::max(density * (high - low), LEAST_PRESSURE);
}

float startingForce(const World& world)
{
    const Vector3f gravity = world.settings.gravity;
    const float strength = gravity.isZero(0) ? EARTH_GRAVITY : gravity.norm();
    float low = std::numeric_limits<float>::infinity(), high = -low, mass = 0.0f;
    for (size_t i = 0; i < world.solidCount(); ++i) {
        const Particle& p = world.particles[i];
        if (isFixed(world, p)) continue;
        const float height = -p.position.dot(gravity) / strength;
        low = std::min(low, height);
        high = std::max(high, height);
        mass = std::max(mass, p.mass);
    }
    return mass > 0.0f ? mass * strength * std::max((high - low) / world.diameter(), LEAST_COLUMN) : 1.0f;
}

}  // namespace

ColorScale colorScaleOf(const World& world, const RenderSettings& settings)
{
    ColorScale scale;
    switch (settings.colorBy) {
        case ColorBy::Speed: scale = {0.0f, settings.speedScale, "speed", "m/s"}; break;
        case ColorBy::Pressure: scale = {0.0f, startingPressure(world), "pressure", "Pa"}; break;
        case ColorBy::Density: scale = {0.9f, 1.1f, "density over that at rest", ""}; break;
        case ColorBy::Strain: scale = {0.0f, 0.3f, "strain", ""}; break;
        case ColorBy::Age: scale = {0.0f, 5.0f, "age", "s"}; break;
        case ColorBy::ContactForce: scale = {0.0f, startingForce(world), "force of contacts", "N"}; break;
        default: break;
    }
    if (settings.colorScale) scale.low = settings.colorScale->x(), scale.high = settings.colorScale->y();
    return scale;
}

Palette paletteOf(const RenderSettings& settings)
{
    if (settings.palette != Palette::Auto) return settings.palette;
    if (settings.colorBy == ColorBy::Speed) return Palette::Heat;
    return settings.colorBy == ColorBy::Density ? Palette::Diverging : Palette::Viridis;
}

Vector3f scaleColor(Palette palette, float share)
{
    const std::span<const uint32_t> anchors = anchorsOf(palette);
    const size_t last = palette == Palette::Heat ? HEAT.size() - 1 : anchors.size() - 1;
    const float place = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(last);
    const size_t below = std::min(static_cast<size_t>(place), last - 1);
    const float part = place - static_cast<float>(below);
    if (palette == Palette::Heat) return HEAT[below] + part * (HEAT[below + 1] - HEAT[below]);
    const Vector3f low = rootsOf(anchors[below]), high = rootsOf(anchors[below + 1]);
    return (low + part * (high - low)).array().square().matrix();
}

Defines colorDefines(const World& world, const RenderSettings& settings)
{
    if (!showsQuantity(settings)) return {};
    Defines defines{{settings.colorBy == ColorBy::Speed ? "COLOR_BY_SPEED" : "COLOR_BY_QUANTITY", "1"}};
    const float low = colorScaleOf(world, settings).low;
    if (low != 0.0f) defines.push_back({"COLOR_LOW", fmt::format("float({})", low)});
    const Palette palette = paletteOf(settings);
    if (palette == Palette::Heat) return defines;
    std::string list;
    const std::span<const uint32_t> anchors = anchorsOf(palette);
    for (const uint32_t anchor : anchors) {
        const Vector3f root = rootsOf(anchor);
        list += fmt::format("{}vec3({:.6f}, {:.6f}, {:.6f})", list.empty() ? "" : ", ", root.x(), root.y(), root.z());
    }
    defines.push_back({"PALETTE_SIZE", std::to_string(anchors.size())});
    defines.push_back({"PALETTE", fmt::format("vec3[{}]({})", anchors.size(), list)});
    return defines;
}

}  // namespace knuckle
