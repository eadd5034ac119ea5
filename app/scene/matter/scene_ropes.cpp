#include "app/scene/matter/scene_ropes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/json/fields.h"
#include "app/scene/matter/scene_fill.h"
#include "app/scene/scene_draw.h"
#include "app/scene/scene_limits.h"
#include "sim/base/errors.h"
#include "sim/world/builder/parts/cloth.h"
#include "sim/world/builder/parts/rope.h"

namespace knuckle {

namespace {

/// How far an end may be from the particle that it is attached to [diameters].
constexpr float ATTACH_REACH = 1.5f;

/// The object `name` that copy number `copy` of this entry is attached to: `name_<copy + 1>` if `name` is repeated as
/// well, else `name` itself.
uint32_t findObject(const ObjectEntry& entry, const std::string& name, size_t copy, const std::string& field)
{
    const std::vector<Object>& objects = entry.context.builder.world().objects;
    std::vector<std::string> names;
    for (const std::string& wanted : {fmt::format("{}_{}", name, copy + 1), name})
        for (uint32_t i = 0; i < objects.size(); ++i)
            if (objects[i].name == wanted) return i;
    for (const Object& object : objects) names.push_back(object.name);
    entry.fail(field + "/object", fmt::format("there is no object \"{}\"; {}", name, suggestion(name, names)));
}

/// The particle of a named object, or of one of its bodies, nearest to a place in the world.
uint32_t findParticle(const ObjectEntry& entry, const Json& json, size_t copy, const Vector3f& place, float reach,
                      const std::string& field)
{
    const World& world = entry.context.builder.world();
    const Object& object = world.objects[findObject(entry, json["object"], copy, field)];
    const std::string body = json["body"];
    std::vector<std::string> names;
    uint32_t nearest = NO_INDEX;
    float best = INFINITY;
    for (uint32_t b = object.bodyStart; b < object.bodyStart + object.bodyCount; ++b) {
        names.push_back(world.bodies[b].name);
        if (!body.empty() && world.bodies[b].name != body) continue;
        for (uint32_t particle : entry.context.builder.ownParticles(b)) {
            const float distance = (world.particles[particle].position - place).norm();
            if (distance >= best) continue;
            best = distance;
            nearest = particle;
        }
    }
    if (nearest == NO_INDEX && body.empty())
        entry.fail(field + "/object", fmt::format("object \"{}\" has no body to attach to", object.name));
    if (nearest == NO_INDEX)
        entry.fail(field + "/body", fmt::format("object \"{}\" has no body \"{}\" with particles of its own; {}",
                                                object.name, body, suggestion(body, names)));
    if (best > reach * world.diameter()) {
        const Vector3f p = world.particles[nearest].position;
        entry.fail(field, fmt::format("\"{}\" is {:.3g} m away from here, its nearest particle at [{:.4g}, {:.4g}, "
                                      "{:.4g}]; begin there",
                                      object.name, best, p.x(), p.y(), p.z()));
    }
    return nearest;
}

RopeEnd readEnd(const ObjectEntry& entry, const char* key, size_t copy, const Vector3f& place)
{
    const Json& json = entry.json[key];
    if (json.is_string()) return {json == "fixed" ? RopeEnd::Kind::Fixed : RopeEnd::Kind::Free, NO_INDEX};
    return {RopeEnd::Kind::Attached, findParticle(entry, json, copy, place, ATTACH_REACH, fmt::format("/{}", key)),
            readUnlessZero(json["releaseTime"])};
}

float readBendCompliance(const Json& json)
{
    const Json& value = json["bendCompliance"];
    return value.is_string() ? std::numeric_limits<float>::infinity() : value.get<float>();
}

void addRopes(const ObjectEntry& entry)
{
    RopeSpec common;
    Vector3f from, to;
    readValue(entry.json["from"], from);
    readValue(entry.json["to"], to);
    common.length = entry.json["length"];
    common.compliance = entry.json["compliance"];
    common.bendCompliance = readBendCompliance(entry.json);
    common.tearForce = readUnlessZero(entry.json["tearForce"]);
    common.material = entry.material;
    common.velocity = entry.velocity;
    common.drawn = isDrawnAs(entry, DrawnAs::Shape, "a rope");
    limitParticles(entry, std::max(common.length, (to - from).norm()) / entry.context.builder.diameter());
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        RopeSpec spec = common;
        spec.from = entry.poses[copy].apply(from);
        spec.to = entry.poses[copy].apply(to);
        spec.start = readEnd(entry, "start", copy, spec.from);
        spec.end = readEnd(entry, "end", copy, spec.to);
        const uint32_t first = entry.context.builder.particleCount();
        addRope(entry.context.builder, entry.copyName(copy), spec);
        entry.context.builder.nameLoose(entry.copyName(copy), first);
    }
}

/// The nodes for a word of `hold`: an edge, a corner as two edges ("nearLeft"), or all edges or corners.
void holdNodes(const ClothSheet& sheet, const std::string& word, std::vector<uint32_t>& held)
{
    const auto has = [&](const char* edge) { return word.find(edge) != std::string::npos; };
    const bool left = has("eft"), right = has("ight"), near = has("near"), far = has("far");
    for (uint32_t j = 0; j < sheet.rows; ++j)
        for (uint32_t k = 0; k < sheet.columns; ++k) {
            const bool first = k == 0, last = k + 1 == sheet.columns, back = j == 0, front = j + 1 == sheet.rows;
            const bool inColumn = left ? first : right ? last : near || far;
            const bool inRow = near ? front : far ? back : left || right;
            const bool named = word == "corners" ? (first || last) && (back || front)
                               : word == "edges" ? first || last || back || front
                                                 : inColumn && inRow;
            if (named) held.push_back(j * sheet.columns + k);
        }
}

void placeCloth(const ObjectEntry& entry, const ClothSheet& sheet, const ClothSpec& spec, std::vector<uint32_t> held)
{
    const std::vector<uint32_t> pinned = pinnedPoints(entry, sheet.nodes);
    held.insert(held.end(), pinned.begin(), pinned.end());
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        std::vector<ClothTie> ties;
        for (size_t i = 0; i < entry.json["attach"].size(); ++i) {
            const Json& json = entry.json["attach"][i];
            Vector3f place;
            readValue(json["point"], place);
            const uint32_t node = nearestPoint(sheet.nodes, place);
            const Vector3f inWorld = entry.poses[copy].apply(sheet.nodes[node]);
            ties.push_back({node, findParticle(entry, json, copy, inWorld, 1.0f, fmt::format("/attach/{}", i))});
        }
        const uint32_t first = entry.context.builder.particleCount();
        addCloth(entry.context.builder, entry.copyName(copy), sheet, spec, held, ties, entry.poses[copy],
                 entry.velocity);
        entry.context.builder.nameLoose(entry.copyName(copy), first);
    }
}

void addCloths(const ObjectEntry& entry)
{
    const Json& json = entry.json;
    const float diameter = entry.context.builder.diameter();
    ClothSpec spec;
    spec.stretchCompliance = json["stretchCompliance"];
    spec.bendCompliance = readBendCompliance(json);
    spec.tearForce = readUnlessZero(json["tearForce"]);
    spec.material = entry.material;
    spec.drawn = isDrawnAs(entry, DrawnAs::Surface, "cloth");
    if (!json["file"].get<std::string>().empty()) {
        if (!json["hold"].empty()) entry.fail("/hold", "a model has no edges by these names; use pins instead");
        const auto model = entry.context.files.model(
            json, entry.context.files.existing(json["file"], entry.pointer + "/file"), false);
        const ClothSheet sheet = meshSheet(model->vertices, model->triangles, diameter, spec, MAX_PARTICLES);
        limitParticles(entry, static_cast<double>(sheet.nodes.size()));
        placeCloth(entry, sheet, spec, {});
        return;
    }
    spec.shearCompliance = json["shearCompliance"];
    const float width = json["size"][0], depth = json["size"][1];
    limitParticles(entry, (width / diameter + 1.0) * (depth / diameter + 1.0));
    const ClothSheet sheet = gridSheet(width, depth, diameter, spec);
    std::vector<uint32_t> held;
    for (const Json& word : json["hold"]) holdNodes(sheet, word, held);
    placeCloth(entry, sheet, spec, held);
}

}  // namespace

bool isRopeObject(const Json& json)
{
    return json["type"] == "rope" || json["type"] == "cloth";
}

void addRopeObject(const ObjectEntry& entry)
{
    if (entry.json["type"] == "rope") addRopes(entry);
    else addCloths(entry);
}

}  // namespace knuckle
