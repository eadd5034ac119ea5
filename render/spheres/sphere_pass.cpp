#include "render/spheres/sphere_pass.h"

#include <span>
#include <vector>

#include "render/fluids/fluid_looks.h"
#include "render/spheres/palette.h"

namespace knuckle {

namespace {

Defines colorDefines(const RenderSettings& settings)
{
    if (settings.colorBy == ColorBy::Speed) return {{"COLOR_BY_SPEED", "1"}};
    return {};
}

/// A bit per particle that is drawn as a grain.
std::vector<uint32_t> grainBits(const World& world)
{
    std::vector<uint32_t> bits(world.particles.size() / 32 + 1, 0);
    for (const ParticleRange& range : world.drawn.grains)
        for (uint32_t grain = range.first; grain < range.end; ++grain) bits[grain / 32] |= 1u << grain % 32;
    return bits;
}

}  // namespace

SpherePass::SpherePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                       const RenderTargets& targets)
    : colors_("sphereColors", particleColors(world, settings)),
      grains_("grainParticles", std::span<const uint32_t>(grainBits(world)))
{
    table.add(Lifetime::Constant, colors_, grains_);
    const auto passes = [&](const Defines& more, bool apart) {
        Defines defines = colorDefines(settings);
        defines.insert(defines.end(), more.begin(), more.end());
        const auto pass = [&](const char* vertex, const char* fragment, const Framebuffer& target) {
            return apart ? DrawPass(gpu, table, {vertex, fragment, defines},
                                    {"frame", "view", "sphereList", "sphereScales", "positions", "velocities",
                                     "sphereColors", "grainParticles", "fluidMaterials"},
                                    target)
                         : DrawPass(gpu, table, {vertex, fragment, defines},
                                    {"frame", "view", "sphereList", "sphereScales", "positions", "velocities",
                                     "sphereColors", "grainParticles"},
                                    target);
        };
        return Passes{pass("spheres/sphere", "spheres/sphere", targets.geometry),
                      pass("spheres/sphere_quad", "spheres/sphere", targets.geometry),
                      pass("spheres/sphere_shadow", "spheres/sphere_shadow", targets.shadowMap)};
    };
    all_ = passes(world.drawn.grains.empty() ? Defines{} : Defines{{"GRAINS", "1"}}, false);
    if (targets.hasSurfaces() && drawsFluids(world, settings, DrawnAs::Particles))
        beads_ = passes({{"BEADS", "1"}}, true);
}

const SpherePass::Passes& SpherePass::of(SphereGroup group) const
{
    return group == SphereGroup::Fluid && beads_ ? *beads_ : all_;
}

void SpherePass::drawShadow(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const
{
    lists.draw(timer, of(group).shadow, group, SHADOW_DRAW);
}

void SpherePass::draw(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const
{
    lists.draw(timer, of(group).points, group, POINT_DRAW);
    lists.draw(timer, of(group).quads, group, QUAD_DRAW);
}

float pointSizeLimit()
{
    GLfloat range[2] = {1, 1};
    glGetFloatv(GL_POINT_SIZE_RANGE, range);
    return range[1];
}

}  // namespace knuckle
