#include <fmt/format.h>

#include "app/scene/scene_parts.h"

namespace knuckle {

namespace {

/// Which of the causes an entry of `release` has.
std::vector<std::string> causesOf(const Json& release)
{
    std::vector<std::string> causes;
    for (const char* number : {"time", "clipTime", "impulse"})
        if (release[number].get<double>() != 0.0) causes.emplace_back(number);
    if (!release["touch"].get<std::string>().empty()) causes.emplace_back("touch");
    if (release.contains("region")) causes.emplace_back("region");
    return causes;
}

}  // namespace

bool waitsForEvent(const ObjectEntry& entry, const Json& release, const std::string& where)
{
    const std::vector<std::string> causes = causesOf(release);
    if (causes.size() > 1) entry.fail(where, fmt::format("has `{}` and `{}`; give one of them", causes[0], causes[1]));
    return !causes.empty() && causes[0] != "time" && causes[0] != "clipTime";
}

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
