#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/run/exit_codes.h"
#include "app/run/interrupt.h"
#include "app/run/open_gpu.h"
#include "sim/base/json.h"
#include "sim/solver/solver.h"

/// What the benchmarks share.
namespace knuckle {

struct BenchOptions {
    std::string name = "table2";
    std::vector<std::string> presets = {"default"}, sets;
    std::string model = "assets/models/humanoid.glb";
    std::vector<uint32_t> objects;
    uint32_t steps = 600, drawnSteps = 60;
    bool json = false;
};

/// A solver's settings by the name of their preset.
using Preset = std::pair<std::string, Settings>;

inline double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The upper one of two in the middle. @param values one at least.
inline double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Runs `count` steps, each followed by `draw`, and waits for the last. @returns seconds.
template <typename Draw>
double timeSteps(Solver& solver, const InterruptGuard& interrupt, uint32_t first, uint32_t count, Draw draw)
{
    const auto start = std::chrono::steady_clock::now();
    for (uint32_t i = 0; i < count; ++i) {
        interrupt.check();
        solver.step();
        solver.checkCounters(first + i);
        draw(first + i);
    }
    glFinish();
    return secondsSince(start);
}

/// How well a state holds together, for the JSON of a run; lengths are over a diameter.
nlohmann::ordered_json measuresToJson(const Measures& measures, float diameter);
/// Runs, with their common settings; docs/output.md describes each key. @param settled steps at the end of each run
/// that count as settled.
nlohmann::ordered_json runsToJson(const BenchOptions& options, const Gpu& gpu, uint32_t settled,
                                  nlohmann::ordered_json runs);

/// Runs each world with each preset, and prints a row for each, or at the end all as JSON. @returns the exit code.
/// @param settled as of runsToJson(). @param runOnce (objects, preset) -> a run, which printRow() and toJson() take.
template <typename RunOnce>
int reportRuns(const BenchOptions& options, const std::vector<Preset>& presets, const Gpu& gpu, uint32_t settled,
               RunOnce runOnce)
{
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const uint32_t objectCount : options.objects)
        for (const Preset& preset : presets) {
            const auto run = runOnce(objectCount, preset);
            if (options.json) runs.push_back(toJson(run));
            else printRow(run);
        }
    if (options.json) fmt::print("{}\n", runsToJson(options, gpu, settled, std::move(runs)).dump(2));
    return EXIT_FINE;
}

/// `bench table2`. @returns the exit code.
int benchTable2(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common);
/// `bench dam` and `bench sand`. @returns the exit code.
int benchColumn(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common);
/// `bench troupe`. @returns the exit code.
int benchTroupe(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common);
/// `bench draw`. @returns the exit code.
int benchDraw(const BenchOptions& options, const CommonOptions& common);
/// `bench water`. @returns the exit code.
int benchWater(const BenchOptions& options, const CommonOptions& common);

}  // namespace knuckle
