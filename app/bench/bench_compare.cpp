#include "app/bench/bench_compare.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "app/bench/bench_run.h"
#include "app/bench/trials.h"
#include "app/json/json.h"
#include "app/run/exit_codes.h"
#include "app/run/interrupt.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// Milliseconds of both, round by round.
struct Times {
    std::vector<double> a, b;
};

/// The path by which it is started from any folder.
std::string programAt(const std::string& path)
{
    std::error_code error;
    const fs::path program = fs::absolute(path, error);
    const bool isFile = fs::is_regular_file(program, error);
    if (!isFile && !error) error = std::make_error_code(std::errc::no_such_file_or_directory);
    if (isFile && access(program.c_str(), X_OK) != 0) error = {errno, std::generic_category()};
    if (error)
        throw InputError(fmt::format("bench compare: {} cannot be run: {}; give the paths of two knuckle programs",
                                     path, error.message()));
    return program.string();
}

std::vector<Trial> chosenTrials(const std::vector<std::string>& names)
{
    std::vector<Trial> chosen;
    for (const Trial& trial : trials())
        if (names.empty() ? trial.byDefault : std::ranges::count(names, trial.name) > 0) chosen.push_back(trial);
    return chosen;
}

/// A first run of each, which compiles, does not count.
Times measure(const Trial& trial, const std::string& a, const std::string& b, const std::string& device,
              uint32_t rounds)
{
    const TrialFolder folder;
    const InterruptGuard interrupt;
    Times times;
    for (uint32_t round = 0; round <= rounds; ++round) {
        const auto run = [&](const std::string& program, const char* name, std::vector<double>& list) {
            interrupt.check();
            const double milliseconds = runTrial(trial, program, device, folder.path() + name);
            if (round > 0) list.push_back(milliseconds);
        };
        const bool reversed = round % 2 == 0;
        if (reversed) run(b, "/b", times.b);
        run(a, "/a", times.a);
        if (!reversed) run(b, "/b", times.b);
    }
    return times;
}

const char* wordOf(const SpeedRatio& ratio)
{
    if (ratio.isFaster()) return "faster";
    return ratio.isSlower() ? "slower" : "none";
}

Json toJson(const Trial& trial, const Times& times, const SpeedRatio& ratio)
{
    return {{"bench", trial.name},         {"what", trial.what},
            {"aMilliseconds", times.a},    {"bMilliseconds", times.b},
            {"medianRatio", ratio.median}, {"lowRatio", ratio.low},
            {"highRatio", ratio.high},     {"confidence", ratio.confidence},
            {"difference", wordOf(ratio)}};
}

void printRow(const Trial& trial, const Times& times, const SpeedRatio& ratio)
{
    fmt::print("{:<8}{:>10.2f}{:>10.2f}   {}\n", trial.name, medianOf(times.a), medianOf(times.b), verdictOf(ratio));
    std::fflush(stdout);
}

}  // namespace

std::string verdictOf(const SpeedRatio& ratio)
{
    const auto percent = [](double r) { return 100.0 * (r - 1.0); };
    const double sure = 100.0 * ratio.confidence;
    if (ratio.isSlower())
        return fmt::format("B is {:.1f} % slower ({:.0f} %: {:.1f} .. {:.1f})", -percent(ratio.median), sure,
                           -percent(ratio.high), -percent(ratio.low));
    if (ratio.isFaster())
        return fmt::format("B is {:.1f} % faster ({:.0f} %: {:.1f} .. {:.1f})", percent(ratio.median), sure,
                           percent(ratio.low), percent(ratio.high));
    return fmt::format("no difference seen ({:.0f} %: {:.1f} .. {:.1f} % faster)", sure, percent(ratio.low),
                       percent(ratio.high));
}

int benchCompare(const CompareProgramsOptions& options, const CommonOptions& common)
{
    const std::string a = programAt(options.a), b = programAt(options.b);
    const std::vector<Trial> chosen = chosenTrials(options.trials);
    if (!options.json) {
        fmt::print("A: {}\nB: {}\nIn turn, {} rounds; medians in milliseconds, and how much less time B takes:\n\n", a,
                   b, options.rounds);
        for (const Trial& trial : chosen) fmt::print("{:<8}{}\n", trial.name, trial.what);
        fmt::print("\nbench            A         B   B beside A\n");
        std::fflush(stdout);
    }
    Json list = Json::array();
    for (const Trial& trial : chosen) {
        const Times times = measure(trial, a, b, common.device, options.rounds);
        const SpeedRatio ratio = speedRatio(times.a, times.b);
        if (options.json) list.push_back(toJson(trial, times, ratio));
        else printRow(trial, times, ratio);
    }
    if (options.json)
        fmt::print(
            "{}\n",
            Json{{"benchmark", "compare"}, {"a", a}, {"b", b}, {"rounds", options.rounds}, {"runs", list}}.dump(2));
    return EXIT_FINE;
}

}  // namespace knuckle
