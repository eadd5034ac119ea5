#include "render/looks/picture_looks.h"

#include <span>

#include "render/fluids/fluid_looks.h"
#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Two texels each, as in shaders/render/picture/light_sources.glsl.
std::vector<gpu::vec4> sourcesOf(const std::vector<LightSource>& lights)
{
    std::vector<gpu::vec4> texels;
    for (const LightSource& light : lights) {
        const Eigen::Vector3f place = light.isPoint ? light.place : light.place.normalized().eval();
        const Eigen::Vector3f color = light.color * light.intensity;
        texels.push_back({place.x(), place.y(), place.z(), light.isPoint ? 1.0f : 0.0f});
        texels.push_back({color.x(), color.y(), color.z(), 0.0f});
    }
    return texels;
}

SurfaceFinish groundFinish(const World& world, const SceneExtent& extent)
{
    return extent.groundCollider != NO_INDEX ? world.colliders[extent.groundCollider].finish : SurfaceFinish();
}

Defines lightingDefines(const World& world, const RenderSettings& settings, const SceneExtent& extent)
{
    Defines defines = joined({Finishes(world).lightingDefines(), displayDefines(settings), skyDefines(settings)});
    if (groundFinish(world, extent) != SurfaceFinish()) defines.push_back({"GROUND_FINISH", "1"});
    if (settings.light.bounce > 0.0f) defines.push_back({"BOUNCE", "1"});
    if (!settings.lights.empty()) defines.push_back({"LIGHTS", std::to_string(settings.lights.size())});
    if (settings.background == Background::Color) defines.push_back({"BACKDROP_COLOR", "1"});
    return defines;
}

}  // namespace

void checkTransparency(const World& world, const RenderSettings& settings)
{
    if (settings.background != Background::Transparent) return;
    if (settings.markJoints || hasGlass(world) || drawsFluids(world, settings, DrawnAs::Surface))
        throw InputError(
            "render.background: \"transparent\" is not drawn with surfaces of fluids, with glass, nor with marks of "
            "joints; draw fluids as \"particles\", or take \"sky\" or a colour");
}

PictureLooks::PictureLooks(BufferTable& table, const World& world, const RenderSettings& settings,
                           const SceneExtent& extent)
    : finishes_("finishes", std::span<const gpu::vec4>(
                                Finishes(world).texels(2.0f * world.particleRadius, groundFinish(world, extent)))),
      sources_("lightSources", std::span<const gpu::vec4>(sourcesOf(settings.lights))), sky_(settings.light.sky.get()),
      lighting_(lightingDefines(world, settings, extent)),
      isMirror_(extent.groundCollider != NO_INDEX && world.colliders[extent.groundCollider].visible &&
                world.colliders[extent.groundCollider].floor == FloorLook::Mirror)
{
    table.add(Lifetime::Constant, finishes_, sources_);
    sky_.addTo(table);
}

}  // namespace knuckle
