#include "app/sweep/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/film/film_outputs.h"
#include "app/film/frame_range.h"
#include "app/schema/schema.h"
#include "app/sweep/sampling.h"
#include "render/output/film_kinds.h"
#include "render/output/frame_names.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// A name that stays in the folder of a run.
void requirePlainName(const JsonFile& file, const std::string& pointer, const std::string& name)
{
    if (name.find('/') == std::string::npos && !name.starts_with('.') && !name.starts_with('-')) return;
    failAt(file.path, pointer, fmt::format("\"{}\" must be a name without folders: it is in that of each run", name));
}

/// The plan's own file, or one beside it; assets are found from anywhere.
std::string besidePlan(const std::string& plan, const std::string& name)
{
    const fs::path beside = (fs::path(plan).parent_path() / name).lexically_normal();
    std::error_code ignored;
    return name.starts_with("assets/") && !fs::exists(beside, ignored) ? name : beside.string();
}

std::string nameOf(const JsonFile& file)
{
    std::string name = file.root.value("name", "");
    if (name.empty()) name = fs::path(file.path).filename().string();
    else requirePlainName(file, "/name", name);
    for (const char* ending : {".json", ".sweep"})
        if (name.size() > std::string(ending).size() && name.ends_with(ending))
            name.resize(name.size() - std::string(ending).size());
    return name;
}

void requireRange(const JsonFile& file, const std::string& pointer, const SweepField& field)
{
    const bool vectors = field.low.is_array() && field.high.is_array();
    if (field.low.is_array() != field.high.is_array() || (vectors && field.low.size() != field.high.size()))
        failAt(file.path, pointer, "has two ends of different length; give both as many numbers");
    if (field.whole)
        for (const Json& end : {field.low, field.high})
            for (const Json& number : end.is_array() ? end : Json::array({end}))
                if (!isWhole(number.get<double>()))
                    failAt(file.path, pointer,
                           fmt::format("{} is no whole number; the field is `whole`", number.dump()));
    for (size_t k = 0; k < (vectors ? field.low.size() : 1); ++k) {
        const double low = vectors ? field.low[k] : field.low, high = vectors ? field.high[k] : field.high;
        if (low > high)
            failAt(file.path, pointer, fmt::format("begins at {} and ends at {}; exchange them", low, high));
    }
}

SweepField readField(const JsonFile& file, const std::string& pointer, const Json& json, bool random)
{
    SweepField field{.path = json["path"], .values = {}, .low = {}, .high = {}, .whole = json["whole"]};
    if (json.contains("values") == json.contains("range"))
        failAt(file.path, pointer, "must have \"values\" or a \"range\", one of them");
    if (json.contains("values")) {
        if (json.contains("count")) failAt(file.path, pointer + "/count", "is of a \"range\"; leave it out");
        field.values = json["values"].get<std::vector<Json>>();
        return field;
    }
    field.low = json["range"][0];
    field.high = json["range"][1];
    requireRange(file, pointer + "/range", field);
    if (json.contains("count")) field.values = evenValues(field, json["count"]);
    else if (!random)
        failAt(file.path, pointer,
               "a range has no end of values: give it a \"count\", or the plan \"runs\", so many at random");
    return field;
}

void checkFields(const JsonFile& file, const SweepPlan& plan)
{
    std::set<std::string> paths;
    for (size_t k = 0; k < plan.fields.size(); ++k)
        if (!paths.insert(plan.fields[k].path).second)
            failAt(file.path, fmt::format("/fields/{}/path", k),
                   fmt::format("{} is given twice; remove one", plan.fields[k].path));
    if (plan.fields.empty() && plan.randomRuns.value_or(1) > 1)
        failAt(file.path, "/runs",
               fmt::format("all {} would be the same; give \"fields\" that differ", *plan.randomRuns));
    if (combinationCount(plan) > MAX_RUNS)
        failAt(file.path, "/fields",
               fmt::format("have more than {} combinations; give \"runs\", so many at random", MAX_RUNS));
}

void checkFrames(const JsonFile& file, const SweepPlan& plan)
{
    for (size_t k = 0; k < plan.frames.size(); ++k) {
        const std::string pointer = fmt::format("/frames/{}", k);
        FrameRange range;
        try {
            range = FrameRange::parse(plan.frames[k]);
        } catch (const InputError& error) {
            failAt(file.path, pointer, error.what());
        }
        if (plan.isStill() && !range.onlyLast && (range.first == 0 || range.first != range.last))
            failAt(file.path, pointer,
                   fmt::format("{} is no single picture; name frames as frame_####.png", plan.output));
    }
    if (plan.isStill() && (plan.parts > 1 || plan.shots))
        failAt(file.path, "/output",
               fmt::format("{} is a single picture, and parts have more; name frames as frame_####.png", plan.output));
    if (plan.shots && (plan.parts > 1 || !plan.frames.empty()))
        failAt(file.path, "/shots", "are ranges of frames by themselves; leave out \"frames\" and \"parts\"");
    if (!plan.simulates()) return;
    if (plan.frames.size() > 1) failAt(file.path, "/frames", "has more ranges than one, which needs \"states\"");
    if (plan.parts > 1) failAt(file.path, "/parts", "needs \"states\": only what is recorded is drawn in parts");
    if (plan.shots) failAt(file.path, "/shots", "needs \"states\": only what is recorded is drawn in parts");
}

bool isPicture(const JsonFile& file, const std::string& output)
{
    try {
        return isFilm(output) || FrameNames::areGivenBy(output);
    } catch (const InputError& error) {
        failAt(file.path, "/output", error.what());
    }
}

void checkOutput(const JsonFile& file, const SweepPlan& plan)
{
    requirePlainName(file, "/output", plan.output);
    if (!isPicture(file, plan.output))
        failAt(file.path, "/output",
               fmt::format("\"{}\" is none: a film ends in {}, frames are named as frame_####.png, a picture as "
                           "still.png",
                           plan.output, choiceOf(FILM_ENDINGS)));
    std::set<std::string> taken{"command", "done.json", "log", "stats.json", plan.output};
    if (!plan.bodies.empty()) taken.insert("bodies.csv");
    for (const auto& [kind, name] : plan.exports) {
        requirePlainName(file, "/exports/" + kind, name);
        if (!taken.insert(name).second)
            failAt(file.path, "/exports/" + kind, fmt::format("\"{}\" is another file of each run; rename it", name));
    }
    if (!plan.simulates() && !plan.bodies.empty())
        failAt(file.path, "/bodies", "are of runs that simulate; leave them out, or \"states\"");
}

}  // namespace

bool SweepPlan::isStill() const
{
    return !isFilm(output) && FrameNames::of(output).digits == 0;
}

SweepPlan parsePlan(JsonFile file)
{
    static const Schema schema("sweep.schema.json");
    schema.complete(file);
    const Json& root = file.root;
    SweepPlan plan;
    plan.path = file.path;
    plan.name = nameOf(file);
    if (root.contains("scene")) plan.scene = besidePlan(file.path, root["scene"]);
    if (root.contains("states")) plan.states = besidePlan(file.path, root["states"]);
    if (plan.scene.empty() && plan.states.empty())
        failAt(file.path, "", "\"scene\" is missing; name a scene file, or \"states\" that were recorded");
    for (const auto& [path, value] : root["set"].items()) plan.changes.push_back({path, value});
    if (root.contains("runs")) plan.randomRuns = root["runs"].get<uint64_t>();
    for (size_t k = 0; k < root["fields"].size(); ++k)
        plan.fields.push_back(
            readField(file, fmt::format("/fields/{}", k), root["fields"][k], plan.randomRuns.has_value()));
    plan.seed = root["seed"];
    if (root.contains("frames")) plan.frames = root["frames"].get<std::vector<std::string>>();
    plan.parts = root["parts"];
    plan.shots = root["shots"];
    plan.output = root["output"];
    for (const auto& [kind, name] : root["exports"].items()) plan.exports.emplace_back(kind, name);
    plan.bodies = root["bodies"].get<std::vector<std::string>>();
    plan.measures = root["measures"].get<std::vector<std::string>>();
    plan.checkpointSeconds = root["checkpoint"];
    checkFields(file, plan);
    checkOutput(file, plan);
    checkFrames(file, plan);
    plan.document = file.root.dump();
    return plan;
}

SweepPlan readPlan(const std::string& path)
{
    return parsePlan(readJsonFile(path));
}

}  // namespace knuckle
