#include "render/picture/picture_passes.h"

#include "render/looks/picture_defines.h"

namespace knuckle {

namespace {

/// So many draws of a frame, each a part of a pixel beside the others, smooth edges by themselves.
constexpr uint32_t DRAWS_THAT_SMOOTH = 4;

}  // namespace

PicturePasses::PicturePasses(const Gpu& gpu, BufferTable& table, RenderTargets& targets, const RenderSettings& settings,
                             const Defines& looks, bool isMirror)
    : targets_(targets), isResolved_(targets.resolved.id() != 0), isMirror_(isMirror),
      smooths_(drawsOf(settings) < DRAWS_THAT_SMOOTH)
{
    const Defines covering = targets.isTransparent() ? Defines{{"TRANSPARENT", "1"}} : Defines{};
    const Defines fluids = targets.hasSurfaces() ? Defines{{"FLUIDS", "1"}} : Defines{};
    occlusion_ = DrawPass(gpu, table, {"picture/screen", "picture/occlusion"},
                          {"depthPicture", "surfacePicture", "shadowPicture"}, targets.occlusion);
    std::vector<std::string> lit = {"depthPicture", "surfacePicture", "shadePicture", "finishes",
                                    "lightSources", "skyPicture",     "skyBlurs"};
    if (targets.hasSurfaces()) lit.insert(lit.end(), {"fluidShadowPicture", "fluidFocusPicture", "fluidDimsPicture"});
    lighting_ = DrawPass(gpu, table, {"picture/screen", "picture/lighting", joined({looks, covering, fluids})}, lit,
                         targets.lighting);
    if (isMirror) {
        const Defines shown = joined({displayDefines(settings), skyDefines(settings)});
        mirror_ = SidedPass(gpu, table, {"picture/screen", "picture/floor_mirror", shown},
                            {"litPicture", "depthPicture", "surfacePicture", "skyPicture", "skyBlurs"}, targets.wet,
                            targets);
    }
    if (settings.skinOpacity < 1.0f) {
        const Defines veiled = joined({looks, covering, {{"VEIL", "1"}}});
        veil_ = DrawPass(
            gpu, table, {"picture/screen", "picture/lighting", veiled},
            {"depthPicture", "surfacePicture", "shadePicture", "finishes", "lightSources", "skyPicture", "skyBlurs"},
            targets.lighting);
        veil_.setOpacity(settings.skinOpacity);
    }
    loadSmoothing(gpu, table, settings, joined({covering, fluids}));
}

void PicturePasses::loadSmoothing(const Gpu& gpu, const BufferTable& table, const RenderSettings& settings,
                                  Defines defines)
{
    std::vector<std::string> edges = {"litPicture", "shadePicture"}, resolved = {"smoothedPicture"};
    if (targets_.hasSurfaces()) edges.push_back("fluidDepthPicture");
    if (targets_.isTransparent()) {
        edges.push_back("coverPicture");
        resolved.push_back("smoothedCoverPicture");
    }
    const bool isDraft = settings.quality == Quality::Draft;
    if (isResolved_)
        resolve_ = DrawPass(gpu, table, {"picture/screen", isDraft ? "picture/enlarge" : "picture/resolve", defines},
                            resolved, targets_.resolve);
    if (targets_.hasGlass()) {
        edges.push_back("glassDepthPicture");
        defines.push_back({"GLASS", "1"});
    }
    edgeFilter_ = DrawPass(gpu, table, {"picture/edge_tile", "picture/edge_filter", defines}, edges, targets_.edges);
}

void PicturePasses::drawOcclusion(KernelTimer& timer) const
{
    // The pass skips pixels in full light.
    targets_.occlusion.clear();
    occlusion_.drawScreen(timer);
}

void PicturePasses::drawMirror(KernelTimer& timer, FluidSide side) const
{
    if (!isMirror_) return;
    targets_.smoothed.copy(targets_.lit);
    mirror_.of(side).drawScreen(timer);
    targets_.lit.copy(targets_.smoothed);
}

void PicturePasses::drawSmooth(KernelTimer& timer) const
{
    // Provides the pixels that the filter skips.
    targets_.smoothed.copy(targets_.lit);
    if (targets_.isTransparent()) targets_.smoothedCover.copy(targets_.cover);
    const auto tiles = [](uint32_t pixels) { return (pixels + EDGE_TILE - 1) / EDGE_TILE; };
    if (smooths_) edgeFilter_.draw(timer, GL_POINTS, tiles(targets_.lit.width()) * tiles(targets_.lit.height()));
    if (isResolved_) resolve_.drawScreen(timer);
}

}  // namespace knuckle
