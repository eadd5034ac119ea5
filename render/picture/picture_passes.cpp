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
                          {"frame", "view", "depthPicture", "surfacePicture", "shadowPicture"}, targets.occlusion);
    const DrawShaders lit{"picture/screen", "picture/lighting", joined({looks, covering, fluids})};
    lighting_ = targets.hasSurfaces()
                    ? DrawPass(gpu, table, lit,
                               {"frame", "view", "depthPicture", "surfacePicture", "shadePicture", "fluidShadowPicture",
                                "fluidFocusPicture", "fluidLooks", "fluidMaterials", "finishes", "lightSources",
                                "skyPicture", "skyBlurs"},
                               targets.lighting)
                    : DrawPass(gpu, table, lit,
                               {"frame", "view", "depthPicture", "surfacePicture", "shadePicture", "finishes",
                                "lightSources", "skyPicture", "skyBlurs"},
                               targets.lighting);
    if (isMirror) {
        const Defines shown = joined({displayDefines(settings), skyDefines(settings)});
        mirror_ = DrawPass(gpu, table, {"picture/screen", "picture/floor_mirror", shown},
                           {"frame", "view", "litPicture", "depthPicture", "surfacePicture", "skyPicture", "skyBlurs"},
                           targets.wet);
    }
    if (settings.skinOpacity < 1.0f) {
        const Defines veiled = joined({looks, covering, {{"VEIL", "1"}}});
        veil_ = DrawPass(gpu, table, {"picture/screen", "picture/lighting", veiled},
                         {"frame", "view", "depthPicture", "surfacePicture", "shadePicture", "finishes", "lightSources",
                          "skyPicture", "skyBlurs"},
                         targets.lighting);
        veil_.setOpacity(settings.skinOpacity);
    }
    const DrawShaders edges{"picture/edge_tile", "picture/edge_filter", joined({covering, fluids})};
    edgeFilter_ =
        targets.hasSurfaces()
            ? DrawPass(gpu, table, edges, {"frame", "litPicture", "shadePicture", "fluidDepthPicture"}, targets.edges)
        : targets.isTransparent()
            ? DrawPass(gpu, table, edges, {"frame", "litPicture", "shadePicture", "coverPicture"}, targets.edges)
            : DrawPass(gpu, table, edges, {"frame", "litPicture", "shadePicture"}, targets.edges);
    if (!isResolved_) return;
    const bool isDraft = settings.quality == Quality::Draft;
    const DrawShaders resolve{"picture/screen", isDraft ? "picture/enlarge" : "picture/resolve", covering};
    resolve_ = targets.isTransparent() ? DrawPass(gpu, table, resolve,
                                                  {"frame", "smoothedPicture", "smoothedCoverPicture"}, targets.resolve)
                                       : DrawPass(gpu, table, resolve, {"frame", "smoothedPicture"}, targets.resolve);
}

void PicturePasses::drawOcclusion(KernelTimer& timer) const
{
    // The pass skips pixels in full light.
    targets_.occlusion.clear();
    occlusion_.drawScreen(timer);
}

void PicturePasses::drawLighting(KernelTimer& timer) const
{
    lighting_.drawScreen(timer);
    if (!isMirror_) return;
    targets_.smoothed.copy(targets_.lit);
    mirror_.drawScreen(timer);
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
