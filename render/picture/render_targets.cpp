#include "render/picture/render_targets.h"

namespace knuckle {

uint32_t shadowSize(const RenderSettings& settings)
{
    return settings.quality == Quality::Draft ? 512 : 1024;
}

RenderTargets::RenderTargets(const RenderSettings& settings, const TargetNeeds& needs)
{
    const DrawnSize drawn = drawnSize(settings);
    const uint32_t factor = settings.antialiasing, w = drawn.width * factor, h = drawn.height * factor;
    const uint32_t halfW = (w + 1) / 2, halfH = (h + 1) / 2, shadowed = shadowSize(settings);
    const bool isTransparent = settings.background == Background::Transparent;
    const bool isDraft = settings.quality == Quality::Draft;
    const GLenum displayed = settings.depth == 16 ? GL_RGBA16 : GL_RGBA8;
    const GLenum color = hasLens(settings) ? GL_RGBA16F : displayed;
    surface = Texture("surfacePicture", GL_RG32UI, w, h);
    depth = Texture("depthPicture", GL_DEPTH_COMPONENT32F, w, h);
    shadow = Texture("shadowPicture", GL_DEPTH_COMPONENT32F, shadowed, shadowed);
    shade = Texture("shadePicture", GL_R32UI, halfW, halfH);
    lit = Texture("litPicture", color, w, h, GL_LINEAR);
    smoothed = Texture("smoothedPicture", color, w, h, isDraft ? GL_LINEAR : GL_NEAREST);
    if (settings.layers) {
        things = Texture("thingPicture", GL_RG32UI, w, h);
        earlier = Texture("earlierPicture", GL_RGBA32F, w, h);
        layerPlaces = Texture("layerPlacePicture", GL_RGBA32F, w, h);
        layerAlbedo = Texture("layerAlbedoPicture", GL_RGBA32F, w, h);
        layers = Framebuffer("layers", {&layerPlaces, &layerAlbedo}, nullptr);
    }
    geometry = hasLayers() ? Framebuffer("geometry", {&surface, &things, &earlier}, &depth)
                           : Framebuffer("geometry", {&surface}, &depth);
    shadowMap = Framebuffer("shadow map", {}, &shadow);
    occlusion = Framebuffer("occlusion", {&shade}, nullptr);
    if (isTransparent) {
        cover = Texture("coverPicture", GL_R8, w, h, GL_LINEAR);
        smoothedCover = Texture("smoothedCoverPicture", GL_R8, w, h);
        lighting = Framebuffer("lighting", {&lit, &cover}, nullptr);
        edges = Framebuffer("edge filter", {&smoothed, &smoothedCover}, nullptr);
    } else {
        lighting = Framebuffer("lighting", {&lit}, nullptr);
        edges = Framebuffer("edge filter", {&smoothed}, nullptr);
    }
    if (factor > 1 || isTransparent || isDraft) {
        resolved = Texture("resolvedPicture", color, settings.width, settings.height);
        resolve = Framebuffer("resolve", {&resolved}, nullptr);
    }
    wet = Framebuffer("wet", {&smoothed}, nullptr);
    if (needs.glass) {
        glassDepth = Texture("glassDepthPicture", GL_DEPTH_COMPONENT32F, w, h);
        glass = Framebuffer("glass", {&smoothed}, &glassDepth);
    }
    if (!needs.fluids) return;
    fluidDepth = Texture("fluidDepthPicture", GL_DEPTH_COMPONENT32F, w, h);
    fluidWide = Texture("fluidWidePicture", GL_R32F, w, h);
    fluidSmooth = Texture("fluidSmoothPicture", GL_R32F, w, h);
    fluidTint = Texture("fluidTintPicture", GL_RGBA16F, halfW, halfH, GL_LINEAR);
    fluidGlow = Texture("fluidGlowPicture", GL_RGBA16F, halfW, halfH, GL_LINEAR);
    foam = Texture("foamPicture", GL_RGBA16F, w, h);
    fluidShadow = Texture("fluidShadowPicture", GL_DEPTH_COMPONENT32F, FLUID_SHADOW_SIZE, FLUID_SHADOW_SIZE);
    fluidBend = Texture("fluidBendPicture", GL_RGBA32F, FLUID_SHADOW_SIZE, FLUID_SHADOW_SIZE);
    fluidFocus = Texture("fluidFocusPicture", GL_RG16F, FLUID_SHADOW_SIZE, FLUID_SHADOW_SIZE, GL_LINEAR);
    if (settings.layers) fluidThings = Texture("fluidThingPicture", GL_RG32UI, w, h);
    fluidFront = settings.layers ? Framebuffer("fluid front", {&fluidThings}, &fluidDepth)
                                 : Framebuffer("fluid front", {}, &fluidDepth);
    fluidRows = Framebuffer("fluid rows", {&fluidWide}, nullptr);
    fluidColumns = Framebuffer("fluid columns", {&fluidSmooth}, nullptr);
    if (needs.emission) fluidEmission = Texture("fluidEmissionPicture", GL_RGBA16F, halfW, halfH, GL_LINEAR);
    fluidInside = needs.emission ? Framebuffer("fluid inside", {&fluidTint, &fluidGlow, &fluidEmission}, nullptr)
                                 : Framebuffer("fluid inside", {&fluidTint, &fluidGlow}, nullptr);
    fluidShadowMap = Framebuffer("fluid shadow map", {}, &fluidShadow);
    fluidBends = Framebuffer("fluid bends", {&fluidBend}, nullptr);
    fluidLens = Framebuffer("fluid lens", {&fluidFocus}, nullptr);
    foamCover = Framebuffer("foam", {&foam}, nullptr);
}

Defines RenderTargets::layerDefines(bool moves) const
{
    if (!hasLayers()) return {};
    return moves ? Defines{{"LAYERS", "1"}, {"MOVES", "1"}} : Defines{{"LAYERS", "1"}};
}

void RenderTargets::addTo(BufferTable& table) const
{
    table.add(surface, depth, shadow, shade, lit, smoothed);
    if (resolved.id() != 0) table.add(resolved);
    if (isTransparent()) table.add(cover, smoothedCover);
    if (hasSurfaces())
        table.add(fluidDepth, fluidWide, fluidSmooth, fluidTint, fluidGlow, fluidShadow, fluidBend, fluidFocus, foam);
    if (hasEmission()) table.add(fluidEmission);
    if (hasGlass()) table.add(glassDepth);
    if (fluidThings.id() != 0) table.add(fluidThings);
}

}  // namespace knuckle
