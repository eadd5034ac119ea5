#include "render/colliders/collider_pass.h"

#include <algorithm>
#include <array>

#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"
#include "shared/draw_types.h"

namespace knuckle {

namespace {

constexpr size_t INSTANCE_VECTORS = sizeof(gpu::ColliderInstance) / sizeof(gpu::vec4);

std::array<gpu::vec4, INSTANCE_VECTORS> instanceOf(const Collider& collider, uint32_t index, uint32_t finish)
{
    Vector3f half = collider.halfExtents;
    float radius = 0.0f;
    if (collider.shape != ColliderShape::Box) {
        radius = collider.radius;
        const float straight = collider.shape == ColliderShape::Capsule ? collider.halfHeight : 0.0f;
        half = {radius, radius + straight, radius};
    }
    return {gpu::vec4{half.x(), half.y(), half.z(), radius},
            {collider.color.x(), collider.color.y(), collider.color.z(), static_cast<float>(collider.shape)},
            {static_cast<float>(index), static_cast<float>(finish), 0.0f, 0.0f}};
}

}  // namespace

ColliderPass::ColliderPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings,
                           const SceneExtent& extent, const RenderTargets& targets)
    : meshes_(gpu, table, world, targets)
{
    upload(world, extent, !settings.layers);
    table.add(Lifetime::Constant, planes_, shapes_);
    const bool haveLooks = std::ranges::any_of(world.colliders,
                                               [](const Collider& c) { return c.floor != FloorLook::Default; });
    const Defines floors = haveLooks ? Defines{{"FLOORS", "1"}} : Defines{};
    planePass_ = DrawPass(gpu, table, {"colliders/plane", "colliders/plane", joined({floors, targets.layerDefines()})},
                          {"colliderPlaces", "colliderPlanes"}, targets.geometry);
    // Draws the far sides of the boxes: they are visible even when the eye is inside.
    shapePass_ = DrawPass(gpu, table,
                          {"colliders/collider", "colliders/collider",
                           joined({Finishes(world).patternDefines(), targets.layerDefines()})},
                          {"colliderPlaces", "colliderShapes", "finishes"}, targets.geometry, GL_FRONT);
    shapeShadow_ = DrawPass(gpu, table, {"colliders/collider", "colliders/collider_shadow", {{"LIGHT_VIEW", "1"}}},
                            {"colliderPlaces", "colliderShapes"}, targets.shadowMap, GL_FRONT);
    if (!hasGlass()) return;
    const Defines last = {{"FIRST_SHAPE", std::to_string(opaqueCount_)}, {"GLASS", "1"}};
    glass_ = SidedPass(gpu, table,
                       {"colliders/collider", "colliders/collider_glass",
                        joined({last, displayDefines(settings), skyDefines(settings)})},
                       {"colliderPlaces", "colliderShapes", "litPicture", "depthPicture", "skyPicture", "skyBlurs"},
                       targets.glass, targets, GL_FRONT);
    glassShadow_ = DrawPass(gpu, table,
                            {"colliders/collider", "colliders/collider_shadow", joined({last, {{"LIGHT_VIEW", "1"}}})},
                            {"colliderPlaces", "colliderShapes"}, targets.shadowMap, GL_FRONT);
}

void ColliderPass::upload(const World& world, const SceneExtent& extent, bool seesThrough)
{
    const Finishes finishes(world);
    std::vector<gpu::vec4> planes, shapes, ofGlass;
    for (uint32_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& collider = world.colliders[i];
        if (!collider.visible || collider.grid != NO_INDEX || collider.floor == FloorLook::None) continue;
        const uint32_t finish = finishes.alphaOf(collider.finish);
        if (collider.shape != ColliderShape::Plane) {
            std::vector<gpu::vec4>& alike = seesThrough && collider.finish.word == Finish::Glass ? ofGlass : shapes;
            for (const gpu::vec4& vector : instanceOf(collider, i, finish)) alike.push_back(vector);
            continue;
        }
        const Vector3f& c = collider.color;
        planes.push_back({c.x(), c.y(), c.z(), i == extent.groundCollider ? 1.0f : 0.0f});
        planes.push_back({static_cast<float>(i), static_cast<float>(collider.floor), static_cast<float>(finish), 0.0f});
    }
    opaqueCount_ = static_cast<uint32_t>(shapes.size() / INSTANCE_VECTORS);
    glassCount_ = static_cast<uint32_t>(ofGlass.size() / INSTANCE_VECTORS);
    shapes.insert(shapes.end(), ofGlass.begin(), ofGlass.end());
    planes_ = {"colliderPlanes", std::span<const gpu::vec4>(planes)};
    shapes_ = {"colliderShapes", std::span<const gpu::vec4>(shapes)};
}

void ColliderPass::draw(KernelTimer& timer) const
{
    planePass_.drawScreen(timer, static_cast<uint32_t>(planes_.size() / 2));
    meshes_.draw(timer);
    drawShapes(timer, shapePass_, opaqueCount_);
}

void ColliderPass::drawShadow(KernelTimer& timer) const
{
    meshes_.drawShadow(timer);
    drawShapes(timer, shapeShadow_, opaqueCount_);
    drawShapes(timer, glassShadow_, glassCount_);
}

void ColliderPass::drawShapes(KernelTimer& timer, const DrawPass& pass, uint32_t count)
{
    if (count > 0) pass.draw(timer, GL_TRIANGLE_STRIP, BOX_STRIP, count);
}

}  // namespace knuckle
