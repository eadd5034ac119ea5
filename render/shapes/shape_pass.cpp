#include "render/shapes/shape_pass.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "render/color_word.h"
#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"
#include "render/quantities/color_scale.h"
#include "render/spheres/palette.h"
#include "render/unseen.h"
#include "shared/draw_types.h"

namespace knuckle {

namespace {

std::span<const Link> linksOf(const World& world, const BodyShape& shape)
{
    const Body& body = world.bodies[shape.body];
    return std::span(world.links).subspan(body.linkStart, body.linkCount);
}

/// The particle of the body that is nearest to a place, from the shape's middle.
uint32_t particleAt(const World& world, const BodyShape& shape, const Vector3f& place)
{
    const Vector3f wanted = shape.middle + place - world.bodies[shape.body].restCentre;
    const auto distance = [&](const Link& link) { return (link.restOffset - wanted).squaredNorm(); };
    return std::ranges::min_element(linksOf(world, shape), {}, distance)->particle;
}

/// Two particles on both sides of the middle, or the one that is there twice.
std::array<uint32_t, 2> middleParticles(const World& world, const BodyShape& shape)
{
    const Body& body = world.bodies[shape.body];
    const uint32_t first = particleAt(world, shape, {0, 0, 0});
    for (const Link& link : linksOf(world, shape))
        if (link.particle == first)
            return {first, particleAt(world, shape, shape.middle - body.restCentre - link.restOffset)};
    return {first, first};
}

bool isSeen(const World& world, const BodyShape& shape, const std::vector<uint32_t>& unseen)
{
    return std::ranges::any_of(linksOf(world, shape), [&](const Link& link) { return !hasBit(unseen, link.particle); });
}

/// SHAPE_TEXELS of each shape that is seen.
struct ShapeTexels {
    std::vector<gpu::vec4> opaque = {}, ofGlass = {};
};

ShapeTexels texelsOf(const World& world, const RenderSettings& settings)
{
    const std::vector<uint32_t> unseen = unseenBits(world);
    const Finishes finishes(world);
    ShapeTexels all;
    for (const BodyShape& shape : world.bodyShapes) {
        if (!isSeen(world, shape, unseen)) continue;
        const Vector3f &half = shape.halfSides, arm = shape.middle - world.bodies[shape.body].restCentre;
        const auto [first, second] = middleParticles(world, shape);
        const uint32_t color = bodyColor(world, shape.body, settings) & COLOR_BITS;
        const SurfaceFinish& finish = world.materials[world.bodies[shape.body].material].finish;
        std::vector<gpu::vec4>& texels = finish.word == Finish::Glass && !settings.layers ? all.ofGlass : all.opaque;
        texels.push_back({half.x(), half.y(), half.z(), shape.radius});
        texels.push_back({arm.x(), arm.y(), arm.z(), static_cast<float>(shape.body)});
        texels.push_back({static_cast<float>(color), static_cast<float>(first), static_cast<float>(second),
                          static_cast<float>(finishes.alphaOf(finish))});
    }
    return all;
}

}  // namespace

ShapePass::ShapePass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                     const RenderTargets& targets)
{
    auto [texels, ofGlass] = texelsOf(world, settings);
    opaqueCount_ = static_cast<uint32_t>(texels.size() / SHAPE_TEXELS);
    glassCount_ = static_cast<uint32_t>(ofGlass.size() / SHAPE_TEXELS);
    texels.insert(texels.end(), ofGlass.begin(), ofGlass.end());
    bodyShapes_ = {"bodyShapes", std::span<const gpu::vec4>(texels)};
    table.add(Lifetime::Constant, bodyShapes_);
    if (texels.empty()) return;
    Defines defines;
    if (settings.colorBy == ColorBy::Speed) defines = colorDefines(world, settings);
    const std::vector<std::string> reads = {"velocities", "bodyShapes", "bodyCentres", "bodyRotations", "finishes"};
    const Defines lightView = joined({defines, {{"LIGHT_VIEW", "1"}}});
    // Draws the far sides of the boxes: they are visible even when the eye is inside.
    shapes_ = DrawPass(
        gpu, table,
        {"shapes/shape", "shapes/shape", joined({Finishes(world).patternDefines(), defines, targets.layerDefines()})},
        reads, targets.geometry, GL_FRONT);
    shadow_ = DrawPass(gpu, table, {"shapes/shape", "shapes/shape_shadow", lightView}, reads, targets.shadowMap,
                       GL_FRONT);
    if (!hasGlass()) return;
    const Defines last = {{"FIRST_SHAPE", std::to_string(opaqueCount_)}, {"GLASS", "1"}};
    glass_ = SidedPass(
        gpu, table,
        {"shapes/shape", "shapes/shape_glass", joined({defines, last, displayDefines(settings), skyDefines(settings)})},
        {"velocities", "bodyShapes", "bodyCentres", "bodyRotations", "litPicture", "depthPicture", "skyPicture",
         "skyBlurs"},
        targets.glass, targets, GL_FRONT);
    glassShadow_ = DrawPass(gpu, table, {"shapes/shape", "shapes/shape_shadow", joined({lightView, last})}, reads,
                            targets.shadowMap, GL_FRONT);
}

void ShapePass::draw(KernelTimer& timer, const DrawPass& pass, uint32_t count)
{
    if (count > 0) pass.draw(timer, GL_TRIANGLE_STRIP, BOX_STRIP, count);
}

}  // namespace knuckle
