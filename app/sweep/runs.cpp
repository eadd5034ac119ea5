#include "app/sweep/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/export/exporters.h"
#include "app/files/assets.h"
#include "app/film/frame_range.h"
#include "app/scene/scene_document.h"
#include "app/scene/scene_file.h"
#include "app/states/states_file.h"
#include "app/sweep/sampling.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

/// Where the scene is read, and what all runs change in it.
struct SceneOrigin {
    std::string file;
    std::vector<Override> changes;
};

SceneOrigin originOf(const SweepPlan& plan, const StatesFile* states)
{
    if (!plan.scene.empty()) return {findAsset(plan.scene), plan.changes};
    const SceneSource& source = states->facts().source;
    SceneOrigin origin{findAsset(source.file), source.changes};
    origin.changes.insert(origin.changes.end(), plan.changes.begin(), plan.changes.end());
    return origin;
}

std::string rangeText(uint64_t first, uint64_t last)
{
    return fmt::format("{}:{}", first, last);
}

/// Frames of the scene's shots, as far as they are recorded.
std::vector<std::string> shotRanges(const SweepPlan& plan, const StatesFile& states)
{
    constexpr double ROUNDING = 1e-6;  // as of shotAt() [s]
    const SceneOrigin origin = originOf(plan, &states);
    const Scene scene = loadScene(origin.file, origin.changes);
    std::vector<uint64_t> starts;
    for (const Shot& shot : scene.render.shots)
        starts.push_back(
            1 + static_cast<uint64_t>(std::max(std::ceil((shot.from - ROUNDING) * scene.framesPerSecond), 0.0)));
    if (starts.empty()) failAt(plan.path, "/shots", "the scene has none; give \"frames\" or \"parts\"");
    std::vector<std::string> ranges;
    const uint64_t begin = states.frames().front(), end = states.frames().back();
    for (size_t k = 0; k < starts.size(); ++k) {
        const uint64_t first = std::max(starts[k], begin);
        const uint64_t last = std::min(k + 1 < starts.size() ? starts[k + 1] - 1 : end, end);
        if (first <= last) ranges.push_back(rangeText(first, last));
    }
    return ranges;
}

/// Each range of frames that is a run.
std::vector<std::string> partsOf(const SweepPlan& plan)
{
    if (plan.simulates()) return {plan.frames.empty() ? std::string() : plan.frames.front()};
    if (plan.isStill() && plan.frames.empty()) return {"last"};
    const StatesFile states(plan.states);
    if (states.frames().empty()) throw InputError(plan.states + ": has no frames to draw");
    if (plan.shots) return shotRanges(plan, states);
    std::vector<std::string> ranges = plan.frames;
    if (ranges.empty()) ranges.push_back(rangeText(states.frames().front(), states.frames().back()));
    if (plan.parts == 1) return ranges;
    std::vector<std::string> parts;
    for (const std::string& text : ranges) {
        const FrameRange range = FrameRange::parse(text);
        const uint64_t first = range.first == 0 ? states.frames().front() : range.first;
        const uint64_t count = (range.last == 0 ? states.frames().back() : range.last) + 1 - first;
        if (range.onlyLast || count < plan.parts)
            failAt(plan.path, "/parts", fmt::format("{} are more than {} has frames; take fewer", plan.parts, text));
        for (uint64_t k = 0; k < plan.parts; ++k)
            parts.push_back(rangeText(first + count * k / plan.parts, first + count * (k + 1) / plan.parts - 1));
    }
    return parts;
}

/// Of the first run.
std::vector<Override> firstChanges(const SweepPlan& plan, const SweepRun& first, const SceneOrigin& origin)
{
    std::vector<Override> changes = origin.changes;
    for (size_t k = 0; k < plan.fields.size(); ++k) changes.push_back({plan.fields[k].path, first.values[k]});
    return changes;
}

/// Calls check(changes, pointer) with each value of each field beside the others' of the first run.
template <typename Check>
void forEachValue(const SweepPlan& plan, const std::vector<Override>& first, const Check& check)
{
    const size_t before = first.size() - plan.fields.size();
    for (size_t k = 0; k < plan.fields.size(); ++k) {
        const SweepField& field = plan.fields[k];
        std::vector<Override> changes = first;
        const std::vector<Json> values = field.values.empty() ? std::vector{field.low, field.high} : field.values;
        for (const Json& value : values) {
            changes[before + k].value = value;
            check(changes, fmt::format("/fields/{}", k));
        }
    }
}

/// Calls the reading of a scene, and tells where in the plan its fault comes from.
template <typename Read>
auto ofPlan(const SweepPlan& plan, const std::string& pointer, const Read& read)
{
    try {
        return read();
    } catch (const InputError& error) {
        failAt(plan.path, pointer, error.what());
    }
}

void checkBodies(const SweepPlan& plan, const World& world)
{
    std::vector<std::string> names;
    for (const Body& body : world.bodies)
        names.push_back((body.object == NO_INDEX ? std::string() : world.objects[body.object].name) + "/" + body.name);
    for (size_t k = 0; k < plan.bodies.size(); ++k)
        if (std::ranges::count(names, plan.bodies[k]) == 0)
            failAt(
                plan.path, fmt::format("/bodies/{}", k),
                fmt::format("\"{}\" is no body of the scene; {}", plan.bodies[k], suggestion(plan.bodies[k], names)));
}

}  // namespace

std::vector<SweepRun> runsOf(const SweepPlan& plan)
{
    const std::vector<std::string> parts = partsOf(plan);
    std::vector<SweepRun> runs;
    const std::vector<std::vector<Json>> samples = sampleFields(plan);
    if (samples.size() * parts.size() > MAX_RUNS)
        failAt(plan.path, "", fmt::format("has {} runs, more than {}", samples.size() * parts.size(), MAX_RUNS));
    for (const std::vector<Json>& values : samples)
        for (const std::string& part : parts) runs.push_back({runs.size() + 1, values, part});
    return runs;
}

void checkScene(const SweepPlan& plan, const std::vector<SweepRun>& runs)
{
    std::optional<StatesFile> states;
    if (!plan.simulates()) states.emplace(plan.states);
    const SceneOrigin origin = originOf(plan, states ? &*states : nullptr);
    const std::vector<Override> first = firstChanges(plan, runs.front(), origin);
    ofPlan(plan, plan.changes.empty() ? "/scene" : "/set",
           [&] { return readSceneDocument(origin.file, origin.changes); });
    forEachValue(plan, first, [&](const std::vector<Override>& changes, const std::string& pointer) {
        ofPlan(plan, pointer, [&] { return readSceneDocument(origin.file, changes); });
    });
    std::vector<std::string> exports;
    for (const auto& [kind, name] : plan.exports) exports.push_back(kind + "=" + name);
    ofPlan(plan, "/exports", [&] { return makeExporters(exports); });
    const Scene scene = ofPlan(plan, "/scene", [&] { return loadScene(origin.file, first); });
    if (!plan.bodies.empty()) checkBodies(plan, scene.world);
    if (plan.simulates() && !plan.frames.empty())
        ofPlan(plan, "/frames/0", [&] { return FrameRange::parse(plan.frames[0]).of(scene, 1); });
}

std::string sweepFingerprint(const SweepPlan& plan)
{
    FnvHash hash;
    hash.add(std::string_view(plan.document));
    if (!plan.scene.empty()) hash.add(readInput(findAsset(plan.scene), "a scene"));
    std::error_code ignored;
    if (!plan.states.empty()) hash.add(uint64_t{std::filesystem::file_size(plan.states, ignored)});
    return hashText(hash.value());
}

}  // namespace knuckle
