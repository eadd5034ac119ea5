#include "render/picture/picture_passes.h"

namespace knuckle {

PicturePasses::PicturePasses(const Gpu& gpu, BufferTable& table, RenderTargets& targets, float veilOpacity)
    : targets_(targets), isResolved_(targets.resolved.id() != 0)
{
    occlusion_ = DrawPass(gpu, table, {"picture/screen", "picture/occlusion"},
                          {"frame", "view", "depthPicture", "surfacePicture", "shadowPicture"}, targets.occlusion);
    lighting_ = targets.hasSurfaces()
                    ? DrawPass(gpu, table, {"picture/screen", "picture/lighting", {{"FLUIDS", "1"}}},
                               {"frame", "view", "depthPicture", "surfacePicture", "shadePicture", "fluidShadowPicture",
                                "fluidLooks", "fluidMaterials"},
                               targets.lighting)
                    : DrawPass(gpu, table, {"picture/screen", "picture/lighting"},
                               {"frame", "view", "depthPicture", "surfacePicture", "shadePicture"}, targets.lighting);
    if (veilOpacity < 1.0f) {
        veil_ = DrawPass(gpu, table, {"picture/screen", "picture/lighting", {{"VEIL", "1"}}},
                         {"frame", "view", "depthPicture", "surfacePicture", "shadePicture"}, targets.lighting);
        veil_.setOpacity(veilOpacity);
    }
    edgeFilter_ = targets.hasSurfaces()
                      ? DrawPass(gpu, table, {"picture/edge_tile", "picture/edge_filter", {{"FLUIDS", "1"}}},
                                 {"frame", "litPicture", "shadePicture", "fluidDepthPicture"}, targets.edges)
                      : DrawPass(gpu, table, {"picture/edge_tile", "picture/edge_filter"},
                                 {"frame", "litPicture", "shadePicture"}, targets.edges);
    if (isResolved_)
        resolve_ = DrawPass(gpu, table, {"picture/screen", "picture/resolve"}, {"frame", "smoothedPicture"},
                            targets.resolve);
}

void PicturePasses::drawOcclusion(KernelTimer& timer) const
{
    // The pass skips pixels in full light.
    targets_.occlusion.clear();
    occlusion_.drawScreen(timer);
}

void PicturePasses::drawSmooth(KernelTimer& timer) const
{
    // Provides the pixels that the filter skips.
    targets_.smoothed.copy(targets_.lit);
    const auto tiles = [](uint32_t pixels) { return (pixels + EDGE_TILE - 1) / EDGE_TILE; };
    edgeFilter_.draw(timer, GL_POINTS, tiles(targets_.lit.width()) * tiles(targets_.lit.height()));
    if (isResolved_) resolve_.drawScreen(timer);
}

}  // namespace knuckle
