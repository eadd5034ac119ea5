#include "render/spheres/sphere_pass.h"

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
    points_ = DrawPass(gpu, table, {"spheres/sphere", "spheres/sphere", colorDefines(settings)},
                       {"frame", "view", "sphereList", "sphereScales", "positions", "velocities", "sphereColors"},
                       targets.geometry);
    quads_ = DrawPass(gpu, table, {"spheres/sphere_quad", "spheres/sphere", colorDefines(settings)},
                      {"frame", "view", "sphereList", "sphereScales", "positions", "velocities", "sphereColors"},
                      targets.geometry);
    shadow_ = DrawPass(gpu, table, {"spheres/sphere_shadow", "spheres/sphere_shadow"},
                       {"frame", "view", "sphereList", "sphereScales", "positions"}, targets.shadowMap);
}

void SpherePass::drawShadow(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const
{
    lists.draw(timer, shadow_, group, SHADOW_DRAW);
}

void SpherePass::draw(KernelTimer& timer, const SphereLists& lists, SphereGroup group) const
{
    lists.draw(timer, points_, group, POINT_DRAW);
    lists.draw(timer, quads_, group, QUAD_DRAW);
}

float pointSizeLimit()
{
    GLfloat range[2] = {1, 1};
    glGetFloatv(GL_POINT_SIZE_RANGE, range);
    return range[1];
}

}  // namespace knuckle
