#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "app/json/fields.h"
#include "app/scene/scene_parts.h"

namespace knuckle {

namespace {

/// @param json of `drive`, one of its `bones`, or its `pin`.
DriveSpring readSpring(const Json& json)
{
    DriveSpring spring;
    spring.frequency = json["frequency"];
    spring.dampingRatio = json["dampingRatio"];
    spring.stiffness = json.value("stiffness", 0.0f);
    spring.damping = json.value("damping", 0.0f);
    spring.greatestTorque = readUnlessZero(json["maxTorque"]);
    if (json.contains("maxForce")) spring.greatestForce = readUnlessZero(json["maxForce"]);
    return spring;
}

/// Of each body the drive of the joint that it hangs on.
std::vector<DriveSpring> readJoints(const ObjectEntry& entry, const Actor& actor)
{
    const Json& drive = entry.json["drive"];
    std::vector<DriveSpring> joints(actor.bodies.size(), readSpring(drive));
    const auto requireOne = [&](const DriveSpring& spring, const std::string& where) {
        if (spring.isGiven() && spring.frequency > 0.0f)
            entry.fail(where, "has a frequency and a stiffness or damping; give one of them");
    };
    requireOne(joints.front(), "/drive");
    for (size_t i = 0; i < drive["bones"].size(); ++i) {
        const Json& bones = drive["bones"][i];
        const std::string pattern = bones["name"], where = fmt::format("/drive/bones/{}", i);
        const DriveSpring spring = readSpring(bones);
        requireOne(spring, where);
        bool any = false;
        for (size_t b = 0; b < joints.size(); ++b) {
            if (fnmatch(pattern.c_str(), actor.bodies[b].name.c_str(), FNM_CASEFOLD) != 0) continue;
            joints[b] = spring;
            any = true;
        }
        if (any) continue;
        std::vector<std::string> known;
        for (const ActorBody& body : actor.bodies) known.push_back(body.name);
        entry.fail(where + "/name", fmt::format("fits no body; {}", suggestion(pattern, known)));
    }
    return joints;
}

std::vector<Pin> readPins(const ObjectEntry& entry, const Actor& actor)
{
    const Json& pin = entry.json["drive"]["pin"];
    const DriveSpring spring = readSpring(pin);
    std::vector<Pin> pins;
    if (!spring.acts()) return pins;
    if (pin["bodies"].empty()) pins.push_back({0, spring});
    for (size_t i = 0; i < pin["bodies"].size(); ++i)
        pins.push_back({bodyNamed(entry, actor, pin["bodies"][i], fmt::format("/drive/pin/bodies/{}", i)), spring});
    return pins;
}

std::vector<StrengthKey> readStrengthKeys(const ObjectEntry& entry)
{
    std::vector<StrengthKey> keys;
    const Json& all = entry.json["drive"]["strength"];
    for (size_t i = 0; i < all.size(); ++i) {
        keys.push_back({all[i]["time"], all[i]["value"], all[i]["ease"] == "smooth"});
        if (i > 0 && keys[i].time < keys[i - 1].time)
            entry.fail(fmt::format("/drive/strength/{}/time", i), "must not be before that of the key before");
    }
    return keys;
}

bool becomesDriven(const Json& release)
{
    const auto driven = [](const Json& one) { return one.value("becomes", "limp") == "driven"; };
    return release.is_array() ? std::ranges::any_of(release, driven) : driven(release);
}

}  // namespace

void driveActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects)
{
    Puppet puppet;
    puppet.joints = readJoints(entry, actor);
    if (std::ranges::none_of(puppet.joints, &DriveSpring::acts)) return;
    if (!namesClip(entry.json["animation"]))
        entry.fail("/drive", "is towards an `animation`; give one, or take it away");
    puppet.pins = readPins(entry, actor);
    puppet.strength = readStrengthKeys(entry);
    puppet.limpTimes.assign(actor.bodies.size(), DriveSpring::INFINITE);
    WorldBuilder& builder = entry.context.builder;
    const bool fromStart = !becomesDriven(entry.json["release"]);
    for (size_t copy = 0; copy < objects.size(); ++copy) {
        puppet.animation = static_cast<uint32_t>(builder.world().animations.size() - objects.size() + copy);
        builder.drive(puppet);
        const Object& object = builder.world().objects[objects[copy]];
        for (uint32_t b = 0; fromStart && b < object.bodyCount; ++b) builder.releaseBody(object.bodyStart + b, 0.0f);
    }
}

}  // namespace knuckle
