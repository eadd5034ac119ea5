#include "render/fluids/underwater_pass.h"

#include "render/looks/picture_defines.h"
#include "render/render_groups.h"

namespace knuckle {

namespace {

constexpr uint32_t TOP_TEXELS = 256;
/// Of underwaterDraws.
constexpr uint32_t POINTS = 0, SCREEN = 1;

}  // namespace

UnderwaterPass::UnderwaterPass(const Gpu& gpu, BufferTable& table, uint32_t fluidCount, const RenderSettings& settings,
                               const RenderTargets& targets)
    : fluidCount_(fluidCount), submersion_("submersion", 1), draws_("underwaterDraws", 2),
      topDepth_("topDepthPicture", GL_DEPTH_COMPONENT32F, TOP_TEXELS, TOP_TEXELS),
      topRows_("topRowsPicture", GL_RGBA32F, TOP_TEXELS, TOP_TEXELS),
      top_("topPicture", GL_RGBA32F, TOP_TEXELS, TOP_TEXELS, GL_LINEAR), topMap_("top map", {}, &topDepth_),
      rowsOfTop_("rows of top", {&topRows_}, nullptr), columnsOfTop_("columns of top", {&top_}, nullptr)
{
    table.add(Lifetime::Scratch, submersion_, draws_);
    table.add(topDepth_, topRows_, top_);
    const Defines surface = {{"SURFACE", "1"}}, size = {{"TOP_TEXELS", std::to_string(TOP_TEXELS) + ".0"}};
    count_ = Kernel(gpu, table, "render/fluids/submersion_count.comp", surface);
    write_ = Kernel(gpu, table, "render/fluids/submersion_draws.comp");
    points_ = DrawPass(gpu, table, {"fluids/fluid_top", "fluids/fluid_top", joined({surface, size})},
                       {"positions", "sphereScales", "fluidMaterials"}, topMap_);
    rows_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_top_smooth", size}, {"topDepthPicture"}, rowsOfTop_);
    columns_ = DrawPass(gpu, table, {"picture/screen", "fluids/fluid_top_smooth", joined({size, {{"COLUMNS", "1"}}})},
                        {"topRowsPicture"}, columnsOfTop_);
    shade_ = DrawPass(
        gpu, table, {"picture/screen", "fluids/underwater", joined({displayDefines(settings), skyDefines(settings)})},
        {"litPicture", "depthPicture", "topPicture", "fluidLooks", "fluidMaterials", "skyPicture", "skyBlurs"},
        targets.wet);
}

void UnderwaterPass::update(KernelTimer& timer)
{
    submersion_.clear();
    count_.dispatch(timer, renderGroups(fluidCount_));
    write_.dispatch(timer, 1);
    topMap_.clear();
    points_.drawIndirect(timer, GL_POINTS, draws_, POINTS);
    rows_.drawIndirect(timer, GL_TRIANGLES, draws_, SCREEN);
    columns_.drawIndirect(timer, GL_TRIANGLES, draws_, SCREEN);
}

void UnderwaterPass::draw(KernelTimer& timer) const
{
    shade_.drawIndirect(timer, GL_TRIANGLES, draws_, SCREEN);
}

}  // namespace knuckle
