#include "app/scene/actors/scene_releases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/json/fields.h"
#include "app/scene/actors/scene_animation.h"
#include "app/scene/actors/scene_bodies.h"
#include "app/scene/actors/scene_drive.h"
#include "app/scene/scene_places.h"
#include "app/scene/scene_repeat.h"

namespace knuckle {

namespace {

/// The causes in an entry of `release`.
std::vector<std::string> causesOf(const Json& release)
{
    std::vector<std::string> causes;
    for (const char* number : {"time", "clipTime", "impulse"})
        if (release[number].get<double>() != 0.0) causes.emplace_back(number);
    if (!release["touch"].get<std::string>().empty()) causes.emplace_back("touch");
    if (release.contains("region")) causes.emplace_back("region");
    return causes;
}

/// Whether an entry of `release` waits for an event. @throws InputError if it has two causes.
bool waitsForEvent(const ObjectEntry& entry, const Json& release, const std::string& where)
{
    const std::vector<std::string> causes = causesOf(release);
    if (causes.size() > 1) entry.fail(where, fmt::format("has `{}` and `{}`; give one of them", causes[0], causes[1]));
    return !causes.empty() && causes[0] != "time" && causes[0] != "clipTime";
}

/// Makes the event of any of an actor's bodies let go of these bodies.
void releaseOnEvent(const ObjectEntry& entry, const Json& json, const std::string& where,
                    const std::vector<uint32_t>& bodies)
{
    Release release;
    release.bodies = bodies;
    release.impulse = json["impulse"];
    release.driven = json["becomes"] == "driven";
    const std::string touched = json["touch"];
    if (!touched.empty()) {
        release.cause = ReleaseCause::Touch;
        entry.context.touches.push_back({entry.pointer + where + "/touch", touched, std::move(release)});
        return;
    }
    if (json.contains("region")) {
        release.cause = ReleaseCause::Region;
        release.region = readRegion(json["region"]);
    }
    entry.context.builder.addRelease(std::move(release));
}

/// When the first clip reaches a time of its own [s]; infinity if it never does.
float timeOf(const World& world, const ClipPlay& play, float clipTime)
{
    const float length = world.clips[play.clip].duration();
    float way = clipTime - play.start;
    if (play.loop && way < 0.0f) way += length;
    if (way < 0.0f || clipTime > length || play.speed == 0.0f) return std::numeric_limits<float>::infinity();
    return way / play.speed;
}

/// The body with a name and what hangs on it; all bodies without a name.
std::vector<uint32_t> bodiesBelow(const ObjectEntry& entry, const Actor& actor, const std::string& name,
                                  const std::string& where)
{
    const int32_t top = name.empty() ? -1 : static_cast<int32_t>(bodyNamed(entry, actor, name, where));
    std::vector<uint32_t> below;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        auto above = static_cast<int32_t>(b);
        while (above >= 0 && above != top) above = actor.bodies[above].parent;
        if (name.empty() || above == top) below.push_back(b);
    }
    return below;
}

/// When one entry of `release` lets go of the first copy [s]; infinity: never.
float timeOfRelease(const ObjectEntry& entry, const Json& json, const std::string& where)
{
    const float time = readUnlessZero(json["time"]), clipTime = readUnlessZero(json["clipTime"]);
    if (std::isinf(clipTime)) return time;
    const World& world = entry.context.builder.world();
    if (!isAnimated(entry.json) || !namesClip(entry.json["animation"]))
        entry.fail(where + "/clipTime", "is for what has an `animation`; give `time`");
    const Animation& first = world.animations[world.animations.size() - entry.poses.size()];
    const float reached = timeOf(world, first.plays.front(), clipTime);
    if (std::isinf(reached)) entry.fail(where + "/clipTime", "is a time that the first clip never gets to");
    return reached;
}

}  // namespace

void releaseActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects)
{
    const Json& json = entry.json["release"];
    const size_t count = json.is_array() ? json.size() : 1;
    WorldBuilder& builder = entry.context.builder;
    for (size_t i = 0; i < count; ++i) {
        const Json& release = json.is_array() ? json[i] : json;
        const std::string where = json.is_array() ? fmt::format("/release/{}", i) : "/release";
        const bool waits = waitsForEvent(entry, release, where);
        const float time = timeOfRelease(entry, release, where);
        const bool driven = release["becomes"] == "driven";
        if (driven && !isDriven(entry.json)) entry.fail(where + "/becomes", "is for what has a `drive`");
        const std::vector<uint32_t> below = bodiesBelow(entry, actor, release["below"], where + "/below");
        if (std::isinf(time) && !waits) continue;
        const auto isHeld = [&](uint32_t body) { return builder.world().bodies[body].motion != Motion::Dynamic; };
        for (size_t copy = 0; copy < objects.size(); ++copy) {
            std::vector<uint32_t> bodies;
            for (const uint32_t b : below) bodies.push_back(builder.world().objects[objects[copy]].bodyStart + b);
            if (std::ranges::none_of(bodies, isHeld))
                entry.fail(where,
                           "is for what is held or animated; set `fixed`, `hold` or `animation`, or take it away");
            if (waits) releaseOnEvent(entry, release, where, bodies);
            for (const uint32_t body : bodies)
                if (!waits && isHeld(body)) builder.letGo(body, time + delayOf(entry.json, copy), driven);
        }
    }
}

void noteParticles(const ObjectEntry& entry, uint32_t first)
{
    SceneContext& context = entry.context;
    const uint32_t end = context.builder.particleCount(), copies = static_cast<uint32_t>(entry.poses.size());
    context.objectNames.push_back(entry.name);
    context.particles[entry.name].push_back({first, end});
    if (copies < 2 || (end - first) % copies != 0) return;
    const uint32_t each = (end - first) / copies;
    for (uint32_t copy = 0; copy < copies; ++copy)
        context.particles[entry.copyName(copy)].push_back({first + copy * each, first + (copy + 1) * each});
}

void addTouches(SceneContext& context)
{
    for (const PendingTouch& touch : context.touches) {
        const auto named = context.particles.find(touch.name);
        if (named == context.particles.end())
            failAt(
                context.path, touch.pointer,
                fmt::format("there is no object \"{}\"; {}", touch.name, suggestion(touch.name, context.objectNames)));
        for (const ParticleRange& range : named->second) {
            if (range.first == range.end)
                failAt(context.path, touch.pointer,
                       fmt::format("\"{}\" is a fluid, which nothing touches; name something solid, or give a "
                                   "`region`",
                                   touch.name));
            Release release = touch.release;
            release.firstParticle = range.first;
            release.endParticle = range.end;
            context.builder.addRelease(std::move(release));
        }
    }
}

}  // namespace knuckle
