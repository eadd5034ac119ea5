#include "app/bench/trials.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "app/bench/bench_run.h"
#include "app/files/assets.h"
#include "app/json/json.h"
#include "app/run/shell_command.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr const char* SCENE = "assets/scenes/hello.json";

std::vector<std::string> start()
{
    return {"render", SCENE, "--frames", "1"};
}

/// The time that a benchmark printed [ms].
double timeIn(const Trial& trial, const std::string& program, const std::string& text)
{
    try {
        const Json run = parseJson(text, program).at("runs").at(0);
        if (!trial.rate.empty()) return 1e3 / run.at(trial.rate).get<double>();
        double sum = 0.0;
        for (const std::string& key : trial.milliseconds) sum += run.at(key).get<double>();
        return sum;
    } catch (const std::exception&) {
        throw RunError(fmt::format("{}: bench {} prints no figures that are known here; leave it out by --bench",
                                   program, trial.name));
    }
}

std::string lineOf(const Trial& trial, const std::string& program, const std::string& device, const std::string& folder)
{
    std::string line = fmt::format("exec {} --quiet --device {}", quotedForShell(program), quotedForShell(device));
    for (const std::string& word : trial.arguments)
        line += " " + quotedForShell(word == SCENE ? fs::absolute(findAsset(word)).string() : word);
    if (trial.arguments[0] == "render") line += " -o " + quotedForShell(folder + "/frames");
    return line;
}

}  // namespace

const std::vector<Trial>& trials()
{
    static const std::vector<Trial> all = {
        {.name = "table2",
         .what = "a step of 100 pairs",
         .arguments = {"bench", "table2", "--objects", "100", "--steps", "300", "--drawn-steps", "0", "--json"},
         .rate = "stepsPerSecond",
         .byDefault = true},
        {.name = "troupe",
         .what = "two steps of 10 figures, one animated and one limp",
         .arguments = {"bench", "troupe", "--objects", "10", "--steps", "120", "--json"},
         .milliseconds = {"animatedMilliseconds", "limpMilliseconds"}},
        {.name = "dam",
         .what = "a step of 8192 particles of water",
         .arguments = {"bench", "dam", "--objects", "2", "--steps", "60", "--json"},
         .milliseconds = {"milliseconds"},
         .byDefault = true},
        {.name = "sand",
         .what = "a step of 8192 grains",
         .arguments = {"bench", "sand", "--objects", "2", "--steps", "60", "--json"},
         .milliseconds = {"milliseconds"}},
        {.name = "draw",
         .what = "a frame of 5 figures in their skins",
         .arguments = {"bench", "draw", "--objects", "5", "--drawn-steps", "10", "--json"},
         .milliseconds = {"skinsMilliseconds"},
         .byDefault = true},
        {.name = "water",
         .what = "a frame of 8192 particles of water as a surface",
         .arguments = {"bench", "water", "--objects", "2", "--drawn-steps", "10", "--json"},
         .milliseconds = {"surfaceMilliseconds"}},
        {.name = "cold",
         .what = "the first frame of hello.json, with no shader compiled before",
         .arguments = start(),
         .emptyCache = true},
        {.name = "warm", .what = "the first frame of hello.json, as a later run makes it", .arguments = start()},
    };
    return all;
}

TrialFolder::TrialFolder() : path_((fs::temp_directory_path() / "knuckle_bench_XXXXXX").string())
{
    if (mkdtemp(path_.data()) == nullptr)
        throw RunError(fmt::format("{}: no temporary folder can be made: {}", path_, std::strerror(errno)));
}

TrialFolder::~TrialFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

double runTrial(const Trial& trial, const std::string& program, const std::string& device, const std::string& folder)
{
    fs::create_directories(folder);
    const std::string cache = folder + "/cache";
    if (trial.emptyCache) fs::remove_all(cache);
    fs::create_directories(cache);
    const std::string line = lineOf(trial, program, device, folder);
    const auto begin = std::chrono::steady_clock::now();
    const ShellResult result = runShell(line, "", {"MESA_SHADER_CACHE_DIR=" + cache, "XDG_CACHE_HOME=" + cache});
    const double milliseconds = 1e3 * secondsSince(begin);
    if (!result.failure.empty())
        throw RunError(fmt::format("{}: {} {}{}", program, trial.name, result.failure,
                                   result.lastLine.empty() ? "" : ": " + result.lastLine));
    const bool byClock = trial.rate.empty() && trial.milliseconds.empty();
    return byClock ? milliseconds : timeIn(trial, program, result.output);
}

}  // namespace knuckle
