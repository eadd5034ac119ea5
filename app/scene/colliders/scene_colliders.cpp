#include "app/scene/colliders/scene_colliders.h"

#include <fmt/format.h>

#include "app/json/fields.h"
#include "app/scene/colliders/scene_grids.h"
#include "app/scene/colliders/scene_motion.h"
#include "app/scene/scene_materials.h"
#include "app/scene/scene_places.h"
#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

/// A part of a composed collider: `base` moved by `offset` in its own frame.
Collider partAt(const Collider& base, const Vector3f& offset)
{
    Collider part = base;
    part.position = base.position + base.orientation * offset;
    return part;
}

void addBox(WorldBuilder& builder, const Collider& base, const Vector3f& centre, const Vector3f& size)
{
    Collider box = partAt(base, centre);
    box.shape = ColliderShape::Box;
    box.halfExtents = 0.5f * size;
    builder.addCollider(box);
}

/// Infinite walls: planes that face inwards.
void addPlaneWalls(WorldBuilder& builder, const Collider& base, float width, float depth)
{
    const Vector3f offsets[] = {{-width / 2, 0, 0}, {width / 2, 0, 0}, {0, 0, -depth / 2}, {0, 0, depth / 2}};
    for (const Vector3f& offset : offsets) {
        Collider wall = partAt(base, offset);
        wall.shape = ColliderShape::Plane;
        wall.orientation = base.orientation * turnBetween(Vector3f::UnitY(), -offset);
        wall.visible = false;
        builder.addCollider(wall);
    }
}

void addContainer(WorldBuilder& builder, const Collider& base, const Json& json)
{
    const float width = json["width"], depth = json["depth"], height = json["height"], thickness = json["thickness"];
    Collider floor = base;
    floor.shape = ColliderShape::Plane;
    builder.addCollider(floor);
    if (height == 0.0f) {
        addPlaneWalls(builder, base, width, depth);
        return;
    }
    const float y = height / 2, x = (width + thickness) / 2, z = (depth + thickness) / 2;
    for (const float side : {-1.0f, 1.0f}) {
        addBox(builder, base, {side * x, y, 0}, {thickness, height, depth});
        addBox(builder, base, {0, y, side * z}, {width + 2 * thickness, height, thickness});
    }
}

void addStairs(WorldBuilder& builder, const Collider& base, const Json& json)
{
    const float rise = json["rise"], run = json["run"], width = json["width"], landing = json["landing"];
    const int steps = json["steps"];
    // Each step extends back to the end of the landing, so that there is no gap between two of them.
    const float end = static_cast<float>(steps - 1) * run + landing;
    for (int i = 0; i < steps; ++i) {
        const float front = static_cast<float>(i) * run, depth = end - front;
        const float top = static_cast<float>(i + 1) * rise;
        addBox(builder, base, {0, top - rise / 2, -front - depth / 2}, {width, rise, depth});
    }
}

void addShapes(const SceneEntry& entry, Collider collider)
{
    WorldBuilder& builder = entry.context.builder;
    const Json& json = entry.json;
    const std::string type = json["type"];
    if (type == "container") return addContainer(builder, collider, json);
    if (type == "stairs") return addStairs(builder, collider, json);
    if (type == "box") {
        Vector3f size;
        readValue(json["size"], size);
        return addBox(builder, collider, {0, 0, 0}, size);
    }
    if (type == "mesh" || type == "heightfield") {
        (type == "mesh" ? addMeshGrid : addHeightfield)(entry, collider);
        return builder.addCollider(collider);
    }
    collider.shape = type == "plane"    ? ColliderShape::Plane
                     : type == "sphere" ? ColliderShape::Sphere
                                        : ColliderShape::Capsule;
    if (json.contains("radius")) readValue(json["radius"], collider.radius);
    if (json.contains("length")) collider.halfHeight = 0.5f * json["length"].get<float>();
    builder.addCollider(collider);
}

}  // namespace

void addColliders(SceneContext& context, const Json& colliders)
{
    WorldBuilder& builder = context.builder;
    for (size_t index = 0; index < colliders.size(); ++index) {
        const Json& json = colliders[index];
        const SceneEntry entry{context, json, fmt::format("/colliders/{}", index)};
        checkFriction(entry);
        Collider collider = readFields<Collider>(json);
        collider.orientation = readRotation(json);
        const size_t before = builder.world().colliders.size();
        addShapes(entry, collider);
        const size_t end = builder.world().colliders.size();
        context.colliderEntries.resize(end, index);
        if (hasMotion(json))
            builder.moveColliders(static_cast<uint32_t>(end - before), {collider.position, collider.orientation},
                                  readMotion(entry, fmt::format("collider {}", index)));
    }
}

}  // namespace knuckle
