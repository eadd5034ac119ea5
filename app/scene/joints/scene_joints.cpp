#include "app/scene/joints/scene_joints.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/json/fields.h"
#include "app/json/joint_limits.h"
#include "sim/base/angles.h"

namespace knuckle {

namespace {

constexpr const char* WORLD = "world";

/// NO_INDEX for the world. @param first bodies from this on are of joints.
uint32_t bodyNamed(const SceneEntry& entry, size_t place, uint32_t end)
{
    const World& world = entry.context.builder.world();
    const std::string name = entry.json["bodies"][place];
    if (name == WORLD) return NO_INDEX;
    std::vector<std::string> known{WORLD};
    for (uint32_t b = 0; b < end; ++b) {
        if (nameInScene(world, world.bodies[b]) == name) return b;
        if (!world.bodies[b].isCross) known.push_back(nameInScene(world, world.bodies[b]));
    }
    const std::string field = fmt::format("/bodies/{}", place);
    for (const Object& object : world.objects)
        if (object.name == name && object.bodyCount > 1)
            entry.fail(field, fmt::format("\"{}\" has {} bodies; name one of them, such as \"{}/{}\"", name,
                                          object.bodyCount, name, world.bodies[object.bodyStart].name));
    if (std::ranges::find(entry.context.objectNames, name) != entry.context.objectNames.end())
        entry.fail(field, fmt::format("\"{}\" is not one rigid body; {}", name, suggestion(name, known)));
    entry.fail(field, fmt::format("there is no body \"{}\"; {}", name, suggestion(name, known)));
}

/// How far a point is from a body's nearest particle, and the size of the box around the body [m].
struct Reach {
    float distance = 1e30f, size = 0.0f;
};

Reach reachOf(const WorldBuilder& builder, uint32_t body, const Vector3f& at)
{
    Reach reach;
    Eigen::AlignedBox3f box;
    for (const uint32_t p : builder.particlesOf(body)) {
        const Vector3f& place = builder.world().particles[p].position;
        box.extend(place);
        reach.distance = std::min(reach.distance, (place - at).norm());
    }
    reach.size = box.diagonal().norm() + builder.diameter();
    return reach;
}

void requireNear(const SceneEntry& entry, const std::vector<uint32_t>& bodies, const Vector3f& at)
{
    float nearest = Reach{}.distance;
    for (const uint32_t body : bodies) {
        const Reach reach = reachOf(entry.context.builder, body, at);
        if (reach.distance <= 2.0f * reach.size) return;
        nearest = std::min(nearest, reach.distance);
    }
    entry.fail("/at", fmt::format("is {:.3g} m from the nearest of its bodies; put it where they meet", nearest));
}

TurnDrive readMotor(const SceneEntry& entry, JointType type)
{
    const Json& json = entry.json["motor"];
    if (type != JointType::Hinge)
        entry.fail("/motor", fmt::format("turns a hinge; a {} joint has no one axis to turn about", wordOf(type)));
    const float torque = json["torque"];
    if (!json.contains("angle")) return speedMotor(json["speed"], torque);
    const float angle = radiansOf(json["angle"]);
    if (!json.contains("speed")) return angleMotor(angle, torque);
    if (json["speed"] <= 0)
        entry.fail("/motor/speed", "must be above 0 beside an `angle`, which says which way to turn");
    return angleMotor(angle, torque, json["speed"]);
}

TurnDrive readSpring(const SceneEntry& entry, JointType type)
{
    const Json& json = entry.json["spring"];
    if (entry.json.contains("motor")) entry.fail("/spring", "is beside a `motor`; leave one of the two out");
    if (type == JointType::Stiff)
        entry.fail("/spring",
                   "turns a joint back; a stiff one does not turn; use a hinge, a ball or a universal joint");
    TurnDrive drive;
    drive.stiffness = json["stiffness"];
    drive.damping = json["damping"];
    drive.angle = radiansOf(json["angle"]);
    if (!drive.acts()) entry.fail("/spring", "neither pulls nor damps; give it a `stiffness` or a `damping` above 0");
    if (drive.needsHinge() && type != JointType::Hinge)
        entry.fail("/spring/angle", fmt::format("is of a hinge; a {} joint's spring turns it back to where it stood; "
                                                "leave it out",
                                                wordOf(type)));
    return drive;
}

JointSpec readSpec(const SceneEntry& entry, size_t index)
{
    const Json& json = entry.json;
    JointSpec spec;
    spec.name = objectName(json, index);
    readValue(json["kind"], spec.type);
    readValue(json["at"], spec.anchor);
    readValue(json["axis"], spec.axis);
    readValue(json["along"], spec.along);
    if (spec.axis.norm() < 1e-6f) entry.fail("/axis", "must not be zero; for instance [0, 0, 1]");
    if (spec.along.isZero()) spec.along = spec.axis.unitOrthogonal();
    if (spec.axis.normalized().cross(spec.along.stableNormalized()).norm() < 1e-3f)
        entry.fail("/along", "must not be along `axis`; leave it out, or turn it across");
    spec.limits = readLimits(json["limits"]);
    spec.strength = readStrength(json);
    requireLimits(entry.context.path, entry.pointer + "/limits", spec.limits, {spec.type});
    spec.geared = spec.type == JointType::Hinge && entry.context.gearedHinges.contains(spec.name);
    if (json.contains("motor")) spec.drive = readMotor(entry, spec.type);
    if (json.contains("spring")) spec.drive = readSpring(entry, spec.type);
    return spec;
}

}  // namespace

std::string nameInScene(const World& world, const Body& body)
{
    const Object& object = world.objects[body.object];
    return object.bodyCount == 1 ? object.name : object.name + "/" + body.name;
}

bool isJoint(const Json& object)
{
    return object["type"] == "joint";
}

void addSceneJoint(const SceneEntry& entry, size_t index)
{
    SceneContext& context = entry.context;
    const JointSpec spec = readSpec(entry, index);
    const auto end = context.bodiesOfObjects;
    uint32_t child = bodyNamed(entry, 0, end), parent = bodyNamed(entry, 1, end);
    if (child == parent)
        entry.fail("/bodies", fmt::format("names \"{}\" twice; a joint holds two bodies, or one and \"world\"",
                                          entry.json["bodies"][0].get<std::string>()));
    for (const auto& [a, b] : context.joinedPairs)
        if (std::minmax(a, b) == std::minmax(child, parent) && parent != NO_INDEX && child != NO_INDEX)
            entry.fail("/bodies", "are joined already; one joint holds two bodies");
    context.joinedPairs.emplace_back(child, parent);
    std::vector<uint32_t> bodies;
    for (const uint32_t body : {child, parent})
        if (body != NO_INDEX) bodies.push_back(body);
    requireNear(entry, bodies, spec.anchor);
    JointSpec placed = spec;
    if (child == NO_INDEX) {
        // The world is the parent: turned about the other way, angles are the same.
        std::swap(child, parent);
        placed.axis = -spec.axis;
        placed.along = -spec.along;
    }
    parent = context.builder.joinPlaced(parent, child, placed);
    if (spec.type == JointType::Hinge) context.hinges[spec.name] = {parent, child};
}

}  // namespace knuckle
