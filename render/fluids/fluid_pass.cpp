#include "render/fluids/fluid_pass.h"

#include "render/fluids/fluid_looks.h"
#include "render/looks/picture_defines.h"
#include "sim/solver/fluid/foam_stage.h"

namespace knuckle {

namespace {

/// Texels per side of the map of what fluids dim of the key light, and about how many particles at most are drawn into
/// it: of more, each one stands for several.
constexpr uint32_t DIMS_SIZE = 128, DIMS_POINTS = 5000;

/// Of surfaces, and none while the camera is in fluid.
Defines outside()
{
    return {{"SURFACE", "1"}, {"FROM_OUTSIDE", "1"}};
}

}  // namespace

FluidPass::FluidPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                     RenderTargets& targets)
    : targets_(targets), count_(targets.hasSurfaces() ? world.fluidCount : 0)
{
    if (empty()) return;
    underwater_.emplace(gpu, table, count_, settings, targets);
    const auto front = [&](const char* vertex) {
        return DrawPass(
            gpu, table, {vertex, "fluids/fluid_front", joined({outside(), targets.layerDefines()})},
            {"sphereList", "sphereScales", "sphereColors", "positions", "fluidMaterials", "fluidForms", "submersion"},
            targets.fluidFront);
    };
    points_ = front("spheres/sphere");
    quads_ = front("spheres/sphere_quad");
    const Defines map = {{"SHADOW_TEXELS", std::to_string(FLUID_SHADOW_SIZE) + ".0"}};
    shadow_ = DrawPass(gpu, table,
                       {"spheres/sphere_shadow", "spheres/sphere_shadow", joined({{{"SURFACE", "1"}}, map})},
                       {"sphereList", "sphereScales", "positions", "fluidMaterials"}, targets.fluidShadowMap);
    loadDims(gpu, table);
    bends_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_focus", map}, {"fluidShadowPicture"},
                      targets.fluidBends);
    focus_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_focus", joined({map, {{"COLUMNS", "1"}}})},
                      {"fluidBendPicture"}, targets.fluidLens);
    rows_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_smooth"}, {"fluidDepthPicture"}, targets.fluidRows);
    columns_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_smooth", {{"COLUMNS", "1"}}}, {"fluidWidePicture"},
                        targets.fluidColumns);
    clean_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_clean"},
                      {"fluidSmoothPicture", "fluidDepthPicture", "depthPicture"}, targets.fluidRows);
    if (targets.hasLayers())
        layer_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_layer"},
                          {"fluidWidePicture", "fluidThingPicture"}, targets.geometry);
    loadShading(gpu, table, settings);
    if (FoamStage::isNeeded(world)) loadFoam(gpu, table, settings);
}

uint32_t FluidPass::dimsStride() const
{
    return 1 + count_ / DIMS_POINTS;
}

void FluidPass::loadDims(const Gpu& gpu, BufferTable& table)
{
    dimsPicture_ = Texture("fluidDimsPicture", GL_RGBA16F, DIMS_SIZE, DIMS_SIZE, GL_LINEAR);
    dimsMap_ = Framebuffer("fluid dims", {&dimsPicture_}, nullptr);
    table.add(dimsPicture_);
    const Defines defines = {{"SURFACE", "1"},
                             {"DIMS_TEXELS", std::to_string(DIMS_SIZE) + ".0"},
                             {"DIMS_STRIDE", std::to_string(dimsStride()) + "u"}};
    dims_ = DrawPass(gpu, table, {"fluids/fluid_dims", "fluids/fluid_dims", defines},
                     {"sphereScales", "positions", "fluidMaterials", "fluidLooks"}, dimsMap_);
    dims_.setAdditive();
}

void FluidPass::loadShading(const Gpu& gpu, const BufferTable& table, const RenderSettings& settings)
{
    const bool emits = targets_.hasEmission();
    const Defines emission = emits ? Defines{{"EMISSION", "1"}} : Defines{};
    tint_ = DrawPass(gpu, table, {"fluids/fluid_tint", "fluids/fluid_tint", joined({outside(), emission})},
                     {"positions", "sphereScales", "fluidLooks", "fluidMaterials", "depthPicture", "submersion"},
                     targets_.fluidInside);
    tint_.setAdditive();
    std::vector<std::string> reads = {"litPicture",       "depthPicture", "fluidWidePicture", "fluidTintPicture",
                                      "fluidGlowPicture", "skyPicture",   "skyBlurs"};
    if (emits) reads.push_back("fluidEmissionPicture");
    shade_ = DrawPass(
        gpu, table,
        {"picture/screen", "fluids/fluid_shade", joined({displayDefines(settings), skyDefines(settings), emission})},
        reads, targets_.wet);
}

void FluidPass::loadFoam(const Gpu& gpu, const BufferTable& table, const RenderSettings& settings)
{
    foam_ = DrawPass(gpu, table, {"fluids/foam", "fluids/foam"},
                     {"foamPlaces", "fluidLooks", "fluidMaterials", "depthPicture", "shadowPicture", "fluidWidePicture",
                      "fluidGlowPicture", "submersion"},
                     targets_.foamCover);
    foam_.setAdditive();
    foamShade_ = DrawPass(gpu, table, {"picture/screen", "fluids/foam_shade", displayDefines(settings)},
                          {"litPicture", "foamPicture"}, targets_.wet);
}

void FluidPass::drawShadow(KernelTimer& timer, const SphereLists& lists) const
{
    targets_.fluidShadowMap.clear();
    lists.draw(timer, shadow_, SphereGroup::Fluid, SHADOW_DRAW);
    dimsMap_.clear();
    dims_.draw(timer, GL_POINTS, (count_ + dimsStride() - 1) / dimsStride());
    bends_.drawScreen(timer);
    focus_.drawScreen(timer);
}

void FluidPass::drawFront(KernelTimer& timer, const SphereLists& lists)
{
    underwater_->update(timer);
    targets_.fluidFront.clear();
    lists.draw(timer, points_, SphereGroup::Fluid, POINT_DRAW);
    lists.draw(timer, quads_, SphereGroup::Fluid, QUAD_DRAW);
}

void FluidPass::smooth(KernelTimer& timer) const
{
    rows_.drawScreen(timer);
    columns_.drawScreen(timer);
    clean_.drawScreen(timer);
}

void FluidPass::drawLayer(KernelTimer& timer, const SphereLists& lists)
{
    drawFront(timer, lists);
    smooth(timer);
    layer_.drawScreen(timer);
}

void FluidPass::drawDepth(KernelTimer& timer, const SphereLists& lists)
{
    drawFront(timer, lists);
    targets_.fluidInside.clear();
    tint_.draw(timer, GL_POINTS, count_);
    smooth(timer);
}

void FluidPass::shade(KernelTimer& timer, uint32_t foamCount)
{
    targets_.smoothed.copy(targets_.lit);
    shade_.drawScreen(timer);
    underwater_->draw(timer);
    targets_.lit.copy(targets_.smoothed);
    if (foamCount > 0) drawFoam(timer, foamCount);
}

void FluidPass::drawFoam(KernelTimer& timer, uint32_t count)
{
    targets_.foamCover.clear();
    foam_.draw(timer, GL_POINTS, count);
    foamShade_.drawScreen(timer);
    targets_.lit.copy(targets_.smoothed);
}

}  // namespace knuckle
