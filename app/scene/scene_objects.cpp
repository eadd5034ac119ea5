#include "app/scene/scene_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/json/fields.h"
#include "app/json/joint_limits.h"
#include "app/scene/actors/scene_actors.h"
#include "app/scene/actors/scene_releases.h"
#include "app/scene/actors/scene_skins.h"
#include "app/scene/colliders/scene_motion.h"
#include "app/scene/joints/scene_gears.h"
#include "app/scene/joints/scene_joints.h"
#include "app/scene/matter/scene_fill.h"
#include "app/scene/matter/scene_fluid.h"
#include "app/scene/matter/scene_grains.h"
#include "app/scene/matter/scene_ropes.h"
#include "app/scene/matter/soft_hulls.h"
#include "app/scene/scene_draw.h"
#include "app/scene/scene_limits.h"
#include "app/scene/scene_materials.h"
#include "app/scene/scene_repeat.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

using Entry = ObjectEntry;

/// The distance of each particle of a rigid body to its surface, and the exit direction; empty for a box, since the
/// builder computes both from its lattice.
std::vector<SurfaceDistance> surfaceOf(const Entry& entry, const std::vector<Vector3f>& positions)
{
    const std::string shape = entry.json["shape"];
    std::vector<SurfaceDistance> surface;
    if (shape == "box") return surface;
    if (shape == "mesh") {
        const Actor& actor = entry.actor();
        for (uint32_t i = 0; i < actor.particles.size(); ++i) surface.push_back(surfaceOf(actor, i));
        return surface;
    }
    const float radius = entry.json["radius"], halfHeight = 0.5f * entry.json.value("length", 0.0f);
    for (const Vector3f& position : positions)
        surface.push_back(capsuleSurface(position, radius, shape == "sphere" ? 0.0f : halfHeight));
    return surface;
}

/// The ball or capsule of a rigid body; none for other shapes.
RoundShape roundShapeOf(const Entry& entry)
{
    const std::string shape = entry.json["shape"];
    if (shape == "sphere") return {entry.json["radius"], 0.0f};
    if (shape == "capsule") return {entry.json["radius"], 0.5f * entry.json["length"].get<float>()};
    return {};
}

/// The shape that the particles of a rigid body fill; without meaning for a mesh.
BodyShape shapeOf(const Entry& entry, const std::vector<Vector3f>& positions)
{
    const RoundShape round = roundShapeOf(entry);
    if (round.exists()) return {0, {0, 0, 0}, {0, round.halfHeight, 0}, round.radius};
    return shapeAround(positions, 0.5f * entry.context.builder.diameter());
}

/// When a held or moved body is let go [s]; infinity: never.
float releaseTime(const Entry& entry, bool held)
{
    const float time = readUnlessZero(entry.json["release"]["time"]);
    if (!held && std::isfinite(time))
        entry.fail("/release",
                   "is for what is held or moved; set `fixed`, `hold` or `motion` as well, or take it away");
    return time;
}

/// How a body is let go that is `fixed` until then.
struct Throw {
    Vector3f velocity{0, 0, 0}, spin{0, 0, 0};
    bool appears = false;
    const char* given = nullptr;  ///< A field that asks for it; null: none does.
};

Throw readThrow(const Json& release)
{
    Throw thrown;
    readValue(release["velocity"], thrown.velocity);
    readValue(release["spin"], thrown.spin);
    thrown.appears = release["appears"];
    if (thrown.appears) thrown.given = "/release/appears";
    if (thrown.spin != Vector3f::Zero()) thrown.given = "/release/spin";
    if (thrown.velocity != Vector3f::Zero()) thrown.given = "/release/velocity";
    return thrown;
}

/// Of a rigid object. @throws InputError where it is not `fixed` until a time.
Throw throwOf(const Entry& entry, bool held, float time)
{
    Throw thrown = readThrow(entry.json["release"]);
    if (thrown.given != nullptr && (!held || std::isinf(time)))
        entry.fail(thrown.given, "is for what is `fixed` until the release's `time`; give both, or take it away");
    return thrown;
}

void addRigidOrSoft(const Entry& entry)
{
    WorldBuilder& builder = entry.context.builder;
    const bool soft = entry.json["type"] == "soft";
    if (soft && entry.json["fixed"].get<bool>())
        entry.fail("/fixed", "a soft body cannot be fixed; use type \"rigid\", or pins");
    const std::vector<Vector3f> positions = fillRegion(entry, builder.diameter());
    const std::vector<SurfaceDistance> surface = soft ? std::vector<SurfaceDistance>() : surfaceOf(entry, positions);
    const std::vector<uint32_t> pinned = soft ? pinnedPoints(entry, positions) : std::vector<uint32_t>();
    const BodyShape shape = soft ? BodyShape() : shapeOf(entry, positions);
    const std::string kind = entry.json["shape"];
    const bool drawsShape = !soft && kind != "mesh" && isDrawnAs(entry, DrawnAs::Shape, "a rigid " + kind);
    const bool drawsSurface = soft && isDrawnAs(entry, DrawnAs::Surface, "a soft body");
    const std::shared_ptr<const SoftHull> hull = drawsSurface ? makeSoftHull(entry, positions) : nullptr;
    const bool held = entry.json["fixed"];
    const bool moved = hasMotion(entry.json);
    const float time = soft ? 0.0f : releaseTime(entry, held || moved);
    const Throw thrown = soft ? Throw() : throwOf(entry, held, time);
    const ClipPlay motion = moved ? readObjectMotion(entry) : ClipPlay();
    std::vector<uint32_t> objects;
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        const float delay = delayOf(entry.json, copy);
        builder.beginObject(entry.copyName(copy));
        if (soft) {
            const uint32_t body = builder.addSoftBody(entry.copyName(copy), positions, entry.material, pinned);
            if (hull) builder.drawSoft({body, hull});
        } else {
            const uint32_t body = builder.addBody("body", positions, entry.material, Motion::Dynamic, surface,
                                                  roundShapeOf(entry));
            if (held) builder.holdBody(body, time + delay);
            if (thrown.given != nullptr) builder.throwBody(body, thrown.velocity, thrown.spin, thrown.appears);
            if (drawsShape) builder.drawShape(body, shape);
        }
        const uint32_t object = builder.endObject(entry.poses[copy], entry.velocity, entry.spin);
        objects.push_back(object);
        if (!moved) continue;
        builder.animate({object, entry.poses[copy], {0, 0, 0}, delayed(builder.world(), {motion}, delay)});
        builder.releaseBody(builder.world().objects[object].bodyStart, time + delay);
    }
    if (showsSkin(entry.json)) wearSkin(entry, entry.actor(), objects);
}

/// Adds the boxes and joints of one chain; requires an open object.
void addChain(const Entry& entry, const JointSpec& common, uint32_t lastMaterial, size_t copy)
{
    WorldBuilder& builder = entry.context.builder;
    const Json& json = entry.json;
    const uint32_t bodies = json["bodies"];
    const Eigen::Vector3i size(json["size"][0].get<int>(), json["size"][1].get<int>(), json["size"][2].get<int>());
    const std::string hold = json["hold"];
    const std::vector<Vector3f> lattice = boxLattice(size, builder.diameter());
    const float pitch = static_cast<float>(size.x() + json["gap"].get<int>()) * builder.diameter();
    const float middle = 0.5f * static_cast<float>(bodies - 1);
    const auto centre = [&](float place) { return Vector3f(pitch * (place - middle), 0, 0); };
    std::vector<uint32_t> indices;
    for (uint32_t b = 0; b < bodies; ++b) {
        std::vector<Vector3f> positions = lattice;
        for (Vector3f& position : positions) position += centre(static_cast<float>(b));
        const bool last = b + 1 == bodies;
        const bool held = (b == 0 && hold != "last" && hold != "none") || (last && hold != "first" && hold != "none");
        indices.push_back(
            builder.addBody(fmt::format("body_{}", b + 1), positions, last ? lastMaterial : entry.material));
        if (isDrawnAs(entry, DrawnAs::Shape, "a chain", last ? lastMaterial : entry.material))
            builder.drawShape(indices.back(), shapeAround(positions, 0.5f * builder.diameter()));
        if (held) builder.holdBody(indices.back(), releaseTime(entry, true) + delayOf(json, copy));
    }
    const Json& types = json["joints"];
    for (uint32_t j = 0; j + 1 < bodies; ++j) {
        JointSpec spec = common;
        spec.type = valueOf<JointType>(types[(copy * (bodies - 1) + j) % types.size()].get<std::string>());
        spec.name = fmt::format("joint_{}", j + 1);
        spec.anchor = centre(static_cast<float>(j) + 0.5f);
        builder.addJoint(indices[j], indices[j + 1], spec);
    }
}

void addJoined(const Entry& entry)
{
    const Json& json = entry.json;
    double particles = json["bodies"].get<double>();
    for (const Json& side : json["size"]) particles *= side.get<double>();
    limitParticles(entry, particles);
    JointSpec common;
    readValue(json["axis"], common.axis);
    common.limitSide = json["limitSide"];
    common.limits = readLimits(json["limits"]);
    common.strength = readStrength(json);
    std::vector<JointType> types;
    for (const Json& type : json["joints"]) types.push_back(valueOf<JointType>(type.get<std::string>()));
    requireLimits(entry.context.path, entry.pointer + "/limits", common.limits, types);
    if (const Throw thrown = readThrow(json["release"]); thrown.given != nullptr)
        entry.fail(thrown.given, "is for an object of type \"rigid\"; take it away");
    if (std::isfinite(releaseTime(entry, json["hold"] != "none")) && json["hold"] == "both" && common.limits.any())
        entry.fail("/release", "a chain that is held at both ends and has limits is a loop, and cannot be let go; hold "
                               "one end, or take the limits away");
    if (common.axis.stableNormalized().cross(Vector3f::UnitX()).norm() < 1e-3f) {
        entry.fail("/axis", "must not be zero or along x, the chain's own direction; for instance [0, 0, 1]");
    }
    const std::string last = json["lastMaterial"];
    const uint32_t lastMaterial = last.empty() ? entry.material
                                               : findMaterial(entry.context, last, entry.pointer + "/lastMaterial");
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        entry.context.builder.beginObject(entry.copyName(copy));
        addChain(entry, common, lastMaterial, copy);
        entry.context.builder.endObject(entry.poses[copy], entry.velocity, entry.spin);
    }
}

/// Adds one entry with its copies.
void addObject(SceneContext& context, const Json& json, size_t index)
{
    Entry entry{{context, json, fmt::format("/objects/{}", index)}, objectName(json, index)};
    entry.material = findMaterial(context, json["material"], entry.pointer + "/material");
    readValue(json["velocity"], entry.velocity);
    if (json.contains("spin")) readValue(json["spin"], entry.spin);
    limitParticles(entry, 1.0);
    if (entry.context.builder.material(entry.material).fluid && json["type"] != "fluid")
        entry.fail("/material", fmt::format("\"{}\" is a fluid; only objects of type \"fluid\" are made of fluids",
                                            json["material"].get<std::string>()));
    entry.poses = repeatedPoses(json);
    if (!json.contains("release") && delayOf(json, entry.poses.size() - 1) > 0.0f)
        entry.fail("/repeat/delay", "is for what is moved or let go; take it away");
    const std::string type = json["type"];
    static const std::map<std::string, std::function<void(const Entry&)>> KINDS = {
        {"rigid", addRigidOrSoft}, {"soft", addRigidOrSoft}, {"joined", addJoined},    {"actor", addActors},
        {"grains", addGrains},     {"rope", addRopeObject},  {"cloth", addRopeObject}, {"fluid", addFluid}};
    const uint32_t first = context.builder.particleCount();
    try {
        KINDS.at(type)(entry);
        if (!json.value("visible", true)) context.builder.hideParticles(first, context.builder.particleCount());
        noteParticles(entry, first);
    } catch (const InputError& error) {
        const std::string text = error.what();
        // Adds the file and the JSON path, which the builder's message lacks.
        throw text.starts_with(context.path) ? error
                                             : InputError(fmt::format("{}: {}: {}", context.path, entry.pointer, text));
    }
}

}  // namespace

void addObjects(SceneContext& context, const Json& objects)
{
    for (const bool rows : {false, true})
        for (size_t i = 0; i < objects.size(); ++i)
            if (!isJoint(objects[i]) && !isGear(objects[i]) && isRopeObject(objects[i]) == rows)
                addObject(context, objects[i], i);
    context.bodiesOfObjects = static_cast<uint32_t>(context.builder.world().bodies.size());
    noteGearedHinges(context, objects);
    for (size_t i = 0; i < objects.size(); ++i)
        if (isJoint(objects[i])) addSceneJoint({context, objects[i], fmt::format("/objects/{}", i)}, i);
    for (size_t i = 0; i < objects.size(); ++i)
        if (isGear(objects[i])) addSceneGear({context, objects[i], fmt::format("/objects/{}", i)}, i);
    addTouches(context);
}

}  // namespace knuckle
