#include "app/scene/colliders/scene_colliders.h"

#include <fmt/format.h>

#include <cmath>

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

Collider readCollider(const Json& json)
{
    Collider collider = readFields<Collider>(json);
    readFinish(json, collider.finish);
    if (json.contains("floor")) readValue(json["floor"], collider.floor);
    collider.orientation = readRotation(json);
    return collider;
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

/// A floor that ends at the walls: a plate as thick as they are.
void addPlate(WorldBuilder& builder, const Collider& base, float width, float depth, float thickness)
{
    addBox(builder, base, {0, -thickness / 2, 0}, {width + 2 * thickness, thickness, depth + 2 * thickness});
}

void addFloor(const SceneEntry& entry, const Collider& base, const Collider* ground)
{
    const Json& json = entry.json;
    Collider floor = base;
    floor.shape = ColliderShape::Plane;
    if (json["height"] == 0.0f) return entry.context.builder.addCollider(floor);
    // Level with the ground nothing of a floor is seen; where it rubs like the ground, nobody feels where it ends.
    if (ground != nullptr && ground->visible) floor.visible = false;
    if (ground != nullptr && !floor.visible && ground->staticFriction == floor.staticFriction &&
        ground->kineticFriction == floor.kineticFriction)
        return entry.context.builder.addCollider(floor);
    addPlate(entry.context.builder, floor, json["width"], json["depth"], json["thickness"]);
}

/// @param ground the plane at rest that the floor is level with, or null.
void addContainer(const SceneEntry& entry, const Collider& base, const Collider* ground)
{
    const Json& json = entry.json;
    WorldBuilder& builder = entry.context.builder;
    const float width = json["width"], depth = json["depth"], height = json["height"], thickness = json["thickness"];
    addFloor(entry, base, ground);
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

/// Endless planes that never move: those of the type, and floors of containers whose walls have no end.
std::vector<Collider> planesAtRest(const Json& colliders)
{
    std::vector<Collider> planes;
    for (const Json& json : colliders) {
        const bool isPlane = json["type"] == "plane" || (json["type"] == "container" && json["height"] == 0.0f);
        if (!isPlane || hasMotion(json)) continue;
        planes.push_back(readCollider(json));
    }
    return planes;
}

/// Of planes, one that the floor at a place lies in, a visible one if there is any.
const Collider* planeAt(const std::vector<Collider>& planes, const Collider& floor)
{
    const Collider* found = nullptr;
    for (const Collider& plane : planes) {
        const Vector3f up = plane.orientation * Vector3f::UnitY();
        if (up.dot(floor.orientation * Vector3f::UnitY()) < 1.0f - 1e-6f) continue;
        if (std::abs(up.dot(floor.position - plane.position)) > 1e-5f) continue;
        if (found == nullptr || plane.visible > found->visible) found = &plane;
    }
    return found;
}

void addShapes(const SceneEntry& entry, Collider collider, const std::vector<Collider>& planes)
{
    WorldBuilder& builder = entry.context.builder;
    const Json& json = entry.json;
    const std::string type = json["type"];
    if (type == "container") {
        const bool rests = !hasMotion(json);
        return addContainer(entry, collider, rests ? planeAt(planes, collider) : nullptr);
    }
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

/// Adds the parts of an entry, and notes where in the scene they are from. @returns how many.
uint32_t addEntry(const SceneEntry& entry, const Collider& collider, const std::vector<Collider>& planes)
{
    checkFriction(entry);
    std::vector<std::string>& entries = entry.context.colliderEntries;
    addShapes(entry, collider, planes);
    const size_t before = entries.size();
    entries.resize(entry.context.builder.world().colliders.size(), entry.pointer);
    return static_cast<uint32_t>(entries.size() - before);
}

Pose framePose(const Json& json)
{
    Vector3f position;
    readValue(json["position"], position);
    return {position, readRotation(json)};
}

/// Parts in the frame of a group that moves as one about its pivot.
void addGroup(const SceneEntry& entry, const std::string& name)
{
    const Pose frame = framePose(entry.json);
    const Json& parts = entry.json["colliders"];
    uint32_t count = 0;
    for (size_t i = 0; i < parts.size(); ++i) {
        const SceneEntry part{entry.context, parts[i], fmt::format("{}/colliders/{}", entry.pointer, i)};
        if (hasMotion(part.json)) part.fail("/motion", "parts of a group move together; give it to the group");
        Collider collider = readCollider(part.json);
        collider.position = frame.apply(collider.position);
        collider.orientation = frame.rotation * collider.orientation;
        count += addEntry(part, collider, {});
    }
    if (!hasMotion(entry.json)) return;
    Vector3f pivot;
    readValue(entry.json["pivot"], pivot);
    entry.context.builder.moveColliders(count, {frame.apply(pivot), frame.rotation}, readMotion(entry, name));
}

}  // namespace

void addColliders(SceneContext& context, const Json& colliders)
{
    const std::vector<Collider> planes = planesAtRest(colliders);
    for (size_t index = 0; index < colliders.size(); ++index) {
        const Json& json = colliders[index];
        const SceneEntry entry{context, json, fmt::format("/colliders/{}", index)};
        const std::string name = fmt::format("collider {}", index);
        if (json["type"] == "group") {
            addGroup(entry, name);
            continue;
        }
        const Collider collider = readCollider(json);
        const uint32_t count = addEntry(entry, collider, planes);
        if (hasMotion(json))
            context.builder.moveColliders(count, {collider.position, collider.orientation}, readMotion(entry, name));
    }
}

}  // namespace knuckle
