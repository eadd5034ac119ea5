#include "render/fluids/fluid_looks.h"

#include <algorithm>

#include "render/quantities/color_scale.h"
#include "render/unseen.h"
#include "shared/draw_types.h"

namespace knuckle {

namespace {

/// As in fluid_looks.glsl.
std::vector<gpu::vec4> looksOf(const World& world)
{
    std::vector<gpu::vec4> looks;
    for (const Material& m : world.materials) {
        // What is left of white light after 1 / absorption is the colour.
        const Vector3f dims = -m.color.cwiseMax(1e-3f).array().log() * m.look.absorption;
        looks.push_back({dims.x(), dims.y(), dims.z(), m.look.scattering});
        looks.push_back({m.color.x(), m.color.y(), m.color.z(), m.look.emission});
    }
    return looks;
}

DrawnAs drawnAs(const Material& material, const RenderSettings& settings)
{
    const bool byParticle = showsQuantity(settings) || settings.colorBy == ColorBy::Particle;
    return byParticle || material.look.drawn == DrawnAs::Particles ? DrawnAs::Particles : DrawnAs::Surface;
}

std::vector<uint32_t> materialsOf(const World& world, const RenderSettings& settings)
{
    const std::vector<uint32_t> unseen = unseenBits(world);
    std::vector<uint32_t> materials;
    for (size_t i = world.particles.size() - world.fluidCount; i < world.particles.size(); ++i) {
        const uint32_t material = world.particles[i].material;
        const bool surface = !hasBit(unseen, i) && drawnAs(world.materials[material], settings) == DrawnAs::Surface;
        materials.push_back(surface ? material : NO_SURFACE);
    }
    return materials;
}

/// Whether any particle of fluid that is to be seen is of such a material.
template <typename Test>
bool anySeenFluid(const World& world, Test test)
{
    const std::vector<uint32_t> unseen = unseenBits(world);
    for (size_t i = world.particles.size() - world.fluidCount; i < world.particles.size(); ++i)
        if (!hasBit(unseen, i) && test(world.materials[world.particles[i].material])) return true;
    return false;
}

}  // namespace

bool drawsFluids(const World& world, const RenderSettings& settings, DrawnAs as)
{
    return anySeenFluid(world, [&](const Material& m) { return drawnAs(m, settings) == as; });
}

bool fluidsEmit(const World& world, const RenderSettings& settings)
{
    return anySeenFluid(
        world, [&](const Material& m) { return m.look.emission > 0.0f && drawnAs(m, settings) == DrawnAs::Surface; });
}

FluidLooks::FluidLooks(BufferTable& table, const World& world, const RenderSettings& settings)
    : looks_("fluidLooks", std::span<const gpu::vec4>(looksOf(world))),
      materials_("fluidMaterials", std::span<const uint32_t>(materialsOf(world, settings)))
{
    table.add(Lifetime::Constant, looks_, materials_);
}

}  // namespace knuckle
