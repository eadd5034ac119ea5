#include "render/spheres/sphere_pass.h"

#include "render/fluids/fluid_looks.h"
#include "render/spheres/palette.h"

namespace knuckle {

namespace {

Defines colorDefines(const RenderSettings& settings)
{
    if (settings.colorBy == ColorBy::Speed) return {{"COLOR_BY_SPEED", "1"}};
    return {};
}

}  // namespace

SpherePass::SpherePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                       const RenderTargets& targets)
    : colors_("sphereColors", particleColors(world, settings))
{
    table.add(Lifetime::Constant, colors_);
    const auto passes = [&](const Defines& more, bool apart) {
        Defines defines = colorDefines(settings);
        defines.insert(defines.end(), more.begin(), more.end());
        const auto pass = [&](const char* vertex, const char* fragment, const Framebuffer& target) {
            return apart ? DrawPass(gpu, table, {vertex, fragment, defines},
                                    {"frame", "view", "sphereList", "sphereScales", "positions", "velocities",
                                     "sphereColors", "fluidMaterials"},
                                    target)
                         : DrawPass(gpu, table, {vertex, fragment, defines},
                                    {"frame", "view", "sphereList", "sphereScales", "positions", "velocities",
                                     "sphereColors"},
                                    target);
        };
        return Passes{pass("spheres/sphere", "spheres/sphere", targets.geometry),
                      pass("spheres/sphere_quad", "spheres/sphere", targets.geometry),
                      pass("spheres/sphere_shadow", "spheres/sphere_shadow", targets.shadowMap)};
    };
    all_ = passes({}, false);
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
