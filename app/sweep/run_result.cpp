#include "app/sweep/run_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "app/checkpoint/checkpoint_folder.h"
#include "app/export/csv.h"
#include "app/film/film_outputs.h"
#include "render/output/frame_names.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// What the run has drawn, in order.
std::vector<std::string> picturesOf(const RunFolder& folder, const SweepPlan& plan)
{
    if (isFilm(plan.output)) return {plan.output};
    const FrameNames names = FrameNames::of(folder.file(plan.output));
    std::vector<std::string> pictures;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path(), ignored))
        if (const std::string name = entry.path().filename(); names.has(name)) pictures.push_back(name);
    // Numbers of more digits are larger.
    std::ranges::sort(pictures, {}, [](const std::string& name) { return std::pair(name.size(), name); });
    if (pictures.empty()) throw InputError(folder.path() + ": has no pictures, though the run says that it is done");
    return pictures;
}

/// Mass centres of some bodies in the last frame of a table of `--export bodies`.
Json centresIn(const std::string& path, const std::vector<std::string>& names)
{
    constexpr size_t OBJECT = 2, NAME = 3, X = 4;  // columns
    Json centres = Json::object();
    std::istringstream lines(readInput(path, "a table of bodies"));
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> cells = csvCells(line);
        if (cells.size() < X + 3) continue;
        const std::string name = cells[OBJECT] + "/" + cells[NAME];
        if (std::ranges::count(names, name) == 0) continue;
        Json& centre = centres[name] = Json::array();
        for (size_t k = X; k < X + 3; ++k) centre.push_back(Json::parse(cells[k], nullptr, false));
    }
    return centres;
}

void readFigures(const RunFolder& folder, const SweepPlan& plan, RunResult& result)
{
    const Json stats = readJsonFile(folder.stats()).root;
    result.hash = stats.at("stateHash");
    result.device = stats.at("device");
    for (const std::string& name : plan.measures) result.measures[name] = stats.at(name);
    if (!plan.bodies.empty()) result.bodies = centresIn(folder.bodies(), plan.bodies);
}

/// Removes what only a run that is not done needs: its checkpoint, and what killed tries have left.
void clear(const RunFolder& folder, const SweepPlan& plan)
{
    std::error_code ignored;
    fs::remove_all(checkpointPath(folder.file(plan.output)), ignored);
    std::vector<fs::path> left;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path(), ignored))
        if (entry.path().filename().string().starts_with(".knuckle")) left.push_back(entry.path());
    for (const fs::path& path : left) fs::remove(path, ignored);
}

}  // namespace

void finishRun(const Sweep& sweep, const SweepRun& run, const std::string& host, double seconds)
{
    const RunFolder folder = sweep.folderOf(run);
    const std::vector<std::string> pictures = picturesOf(folder, sweep.plan);
    RunResult result{.hash = {}, .picture = pictures.back(), .device = {}, .host = host, .seconds = seconds};
    if (sweep.plan.simulates()) readFigures(folder, sweep.plan, result);
    else {
        FnvHash hash;
        for (const std::string& picture : pictures) hash.add(readInput(folder.file(picture), "a picture"));
        result.hash = hashText(hash.value());
    }
    const Json json = {{"hash", result.hash},    {"picture", result.picture}, {"device", result.device},
                       {"host", result.host},    {"seconds", result.seconds}, {"measures", result.measures},
                       {"bodies", result.bodies}};
    OutputFile file(folder.done());
    file.write(json.dump(2) + "\n");
    file.commitDurably();
    clear(folder, sweep.plan);
}

std::optional<RunResult> readResult(const RunFolder& folder)
{
    if (!folder.isDone()) return {};
    const Json json = readJsonFile(folder.done()).root;
    try {
        return RunResult{json.at("hash"),     json.at("picture"), json.at("device"), json.at("host"),
                         json.at("measures"), json.at("bodies"),  json.at("seconds")};
    } catch (const Json::exception&) {
        throw InputError(
            fmt::format("{}: is none of this program's; remove it, and the run is done again", folder.done()));
    }
}

}  // namespace knuckle
