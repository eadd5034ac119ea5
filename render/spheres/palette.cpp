#include "render/spheres/palette.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/color_word.h"
#include "render/looks/finishes.h"
#include "render/quantities/color_scale.h"
#include "render/skins/skin_colors.h"
#include "shared/draw_types.h"

namespace knuckle {

namespace {

const Vector3f JOINT_COLOR{0.80f, 0.015f, 0.012f};
const Vector3f LOOSE_COLOR{0.62f, 0.50f, 0.33f};

const Vector3f NO_QUANTITY_COLOR = Vector3f::Constant(NO_QUANTITY_GREY);

bool hasQuantity(const World& world, uint32_t particle, ColorBy quantity)
{
    if (quantity == ColorBy::Age) return true;
    const bool isFluid = particle >= world.particles.size() - world.fluidCount;
    if (quantity == ColorBy::ContactForce) return !isFluid;
    if (quantity != ColorBy::Strain) return isFluid;
    return std::ranges::any_of(
        world.softBodies, [&](const SoftBody& soft) { return particle - soft.particleStart < soft.particleCount; });
}

uint32_t colorWord(const World& world, uint32_t index, const RenderSettings& settings)
{
    const Particle& particle = world.particles[index];
    switch (settings.colorBy) {
        case ColorBy::Speed: return 0;
        case ColorBy::Pressure:
        case ColorBy::Density:
        case ColorBy::Strain:
        case ColorBy::Age:
        case ColorBy::ContactForce:
            return hasQuantity(world, index, settings.colorBy) ? 0 : packColor(NO_QUANTITY_COLOR);
        case ColorBy::Material: return packColor(world.materials[particle.material].color);
        case ColorBy::Particle: return packColor(paletteColor(index));
        case ColorBy::Body: break;
    }
    if (particle.body != NO_INDEX) return bodyColor(world, particle.body, settings);
    if (world.materials[particle.material].fluid) return packColor(world.materials[particle.material].color);
    // Soft bodies by their assembly, after the rigid ones.
    const auto bodies = static_cast<uint32_t>(world.bodies.size());
    return packColor(particle.assembly != NO_INDEX ? paletteColor(bodies + particle.assembly) : LOOSE_COLOR);
}

}  // namespace

Vector3f fromOklch(float lightness, float chroma, float hue)
{
    const float a = chroma * std::cos(hue), b = chroma * std::sin(hue);
    const float l = lightness + 0.3963377774f * a + 0.2158037573f * b;
    const float m = lightness - 0.1055613458f * a - 0.0638541728f * b;
    const float s = lightness - 0.0894841775f * a - 1.2914855480f * b;
    const Vector3f cone(l * l * l, m * m * m, s * s * s);
    const Vector3f rgb(4.0767416621f * cone.x() - 3.3077115913f * cone.y() + 0.2309699292f * cone.z(),
                       -1.2684380046f * cone.x() + 2.6097574011f * cone.y() - 0.3413193965f * cone.z(),
                       -0.0041960863f * cone.x() - 0.7034186147f * cone.y() + 1.7076147010f * cone.z());
    return rgb.cwiseMax(0.0f).cwiseMin(1.0f);
}

Vector3f paletteColor(uint32_t index)
{
    // In double: for the millionth particle a float would have lost the fraction.
    const double turns = 0.08 + index * (std::numbers::phi - 1.0);
    const double hue = (turns - std::floor(turns)) * 2.0 * std::numbers::pi;
    // Three tones, so that repeated hues still differ.
    const float tone = static_cast<float>(index % 3);
    return fromOklch(0.70f - 0.06f * tone, 0.125f + 0.01f * tone, static_cast<float>(hue));
}

uint32_t bodyColor(const World& world, uint32_t body, const RenderSettings& settings)
{
    if (settings.colorBy == ColorBy::Speed) return 0;
    if (showsQuantity(settings)) return packColor(NO_QUANTITY_COLOR);
    const bool byMaterial = settings.colorBy == ColorBy::Material;
    return packColor(byMaterial ? world.materials[world.bodies[body].material].color : paletteColor(body));
}

std::vector<uint32_t> particleColors(const World& world, const RenderSettings& settings)
{
    std::vector<uint32_t> colors(world.particles.size());
    for (uint32_t i = 0; i < colors.size(); ++i) colors[i] = colorWord(world, i, settings);
    if (settings.colorBy == ColorBy::Body) paintParticles(world, colors);
    const Finishes finishes(world);
    for (uint32_t i = 0; i < colors.size(); ++i)
        colors[i] = finishes.withFinish(colors[i], world.materials[world.particles[i].material].finish);
    if (settings.highlightJoints)
        for (uint32_t i = 0; i < colors.size(); ++i)
            if (world.particles[i].bodyCount > 1) colors[i] = packColor(JOINT_COLOR);
    return colors;
}

}  // namespace knuckle
