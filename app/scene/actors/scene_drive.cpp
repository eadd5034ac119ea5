#include "app/scene/actors/scene_drive.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "app/json/fields.h"
#include "app/scene/actors/scene_animation.h"
#include "app/scene/actors/scene_bodies.h"
#include "app/scene/scene_repeat.h"

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

/// Per body, the drive of the joint that it hangs on.
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
        if (!any) entry.fail(where + "/name", fmt::format("fits no body; {}", suggestion(pattern, bodyNames(actor))));
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

void readHits(const Json& drive, Puppet& puppet)
{
    const Json &hit = drive["hitReaction"], &knockOut = drive["knockOut"];
    puppet.hit = {readUnlessZero(hit["impulse"]), hit["falloff"], hit["hold"], hit["recover"]};
    puppet.knockOut = {readUnlessZero(knockOut["distance"]), readUnlessZero(knockOut["torqueTime"])};
}

/// None if it is never caught.
std::optional<Catch> readCatch(const Json& json, size_t bodies)
{
    if (json["time"] == 0.0) return std::nullopt;
    Catch caught;
    caught.time = json["time"];
    caught.blend = json["blend"];
    caught.near = json["near"];
    caught.within = json["within"];
    caught.here = json["where"] == "here";
    if (json["otherwise"] == "driven") caught.otherwise = Catch::Otherwise::Driven;
    if (json["otherwise"] == "animated") caught.otherwise = Catch::Otherwise::Animated;
    caught.releaseTimes.assign(bodies, DriveSpring::INFINITE);
    caught.limpTimes = caught.releaseTimes;
    return caught;
}

/// The same for a copy with a delay [s].
Puppet delayed(Puppet puppet, float delay)
{
    for (StrengthKey& key : puppet.strength) key.time += delay;
    if (puppet.caught) puppet.caught->time += delay;
    return puppet;
}

bool becomesDriven(const Json& release)
{
    const auto driven = [](const Json& one) { return one.value("becomes", "limp") == "driven"; };
    return release.is_array() ? std::ranges::any_of(release, driven) : driven(release);
}

}  // namespace

bool isDriven(const Json& actor)
{
    const auto acts = [](const Json& json) { return readSpring(json).acts(); };
    return acts(actor["drive"]) || std::ranges::any_of(actor["drive"]["bones"], acts);
}

void driveActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects)
{
    constexpr float CATCHING = 6.0f;  // [Hz], for puppets without a drive
    Puppet puppet;
    puppet.joints = readJoints(entry, actor);
    puppet.caught = readCatch(entry.json["catch"], actor.bodies.size());
    const bool driven = std::ranges::any_of(puppet.joints, &DriveSpring::acts);
    if (!driven && !puppet.caught) return;
    if (driven && !namesClip(entry.json["animation"]))
        entry.fail("/drive", "is towards an `animation`; give one, or take it away");
    if (!isAnimated(entry.json)) entry.fail("/catch", "is for what has an `animation` or a `pose`; give one");
    for (DriveSpring& spring : puppet.joints)
        if (!driven) spring.frequency = CATCHING;
    readHits(entry.json["drive"], puppet);
    puppet.pins = readPins(entry, actor);
    puppet.strength = readStrengthKeys(entry);
    puppet.limpTimes.assign(actor.bodies.size(), driven ? DriveSpring::INFINITE : 0.0f);
    WorldBuilder& builder = entry.context.builder;
    const bool posed = namesClip(entry.json["pose"]);
    const bool fromStart = driven && !becomesDriven(entry.json["release"]);
    for (size_t copy = 0; copy < objects.size(); ++copy) {
        puppet.animation = static_cast<uint32_t>(builder.world().animations.size() - objects.size() + copy);
        builder.drive(delayed(puppet, posed ? 0.0f : delayOf(entry.json, copy)));
        const Object& object = builder.world().objects[objects[copy]];
        for (uint32_t b = 0; fromStart && b < object.bodyCount; ++b) builder.releaseBody(object.bodyStart + b, 0.0f);
    }
}

}  // namespace knuckle
