#include <fmt/format.h>

#include <algorithm>

#include "app/bench/bench_run.h"
#include "app/bench/bench_worlds.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

constexpr int SIDE = 16;  // of a block, particles
constexpr uint32_t SETTLED_STEPS = 60;

struct ColumnRun {
    std::string preset;
    uint32_t blockCount = 0;
    size_t particleCount = 0;
    uint32_t substeps = 0;
    double milliseconds = 0.0, settledMilliseconds = 0.0;  ///< A step.
    float maxSpeed = 0.0f;                                 ///< At the end [m/s].

    double microsecondsPerParticle() const { return 1e3 * milliseconds / static_cast<double>(particleCount); }
};

World worldOf(uint32_t blockCount, const BenchOptions& options, const Settings& settings)
{
    const Eigen::Vector3i counts(SIDE, SIDE, SIDE * static_cast<int>(blockCount));
    return options.name == "dam" ? damWorld(counts, settings) : sandWorld(counts, settings);
}

ColumnRun runOnce(Gpu& gpu, uint32_t blockCount, const Preset& preset, const BenchOptions& options)
{
    const World world = worldOf(blockCount, options, preset.second);
    Solver solver(gpu, world);
    const InterruptGuard interrupt;
    const uint32_t settled = std::min(SETTLED_STEPS, options.steps);
    const auto seconds = [&](uint32_t first, uint32_t count) {
        return timeSteps(solver, interrupt, first + 1, count, [](uint32_t) {});
    };
    const double breaking = seconds(0, options.steps - settled), resting = seconds(options.steps - settled, settled);
    return {.preset = preset.first,
            .blockCount = blockCount,
            .particleCount = world.particles.size(),
            .substeps = world.settings.substeps,
            .milliseconds = 1e3 * (breaking + resting) / options.steps,
            .settledMilliseconds = 1e3 * resting / settled,
            .maxSpeed = solver.measure().maxSpeed};
}

nlohmann::ordered_json toJson(const ColumnRun& run)
{
    return {{"preset", run.preset},
            {"blockCount", run.blockCount},
            {"particleCount", run.particleCount},
            {"substeps", run.substeps},
            {"milliseconds", run.milliseconds},
            {"settledMilliseconds", run.settledMilliseconds},
            {"microsecondsPerParticle", run.microsecondsPerParticle()},
            {"maxSpeed", run.maxSpeed}};
}

void printRow(const ColumnRun& run)
{
    fmt::print("{:<8}{:6}{:11}{:10}{:9.2f}{:9.2f}{:13.2f}{:8.2f}\n", run.preset, run.blockCount, run.particleCount,
               run.substeps, run.milliseconds, run.settledMilliseconds, run.microsecondsPerParticle(), run.maxSpeed);
    std::fflush(stdout);
}

}  // namespace

int benchColumn(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common)
{
    const uint32_t most = *std::max_element(options.objects.begin(), options.objects.end());
    const auto gpu = openGpu(common, FrameWork{stepWorkload(worldOf(most, options, presets.back().second)), {}});
    if (!options.json) {
        fmt::print("A column of {} breaks on {}: {} steps of 1/60 s; ms a step of all and of the last {}; us a\n"
                   "particle and step; the fastest particle at the end in m/s.\n\n"
                   "preset  blocks  particles  substeps      all  settled  us/particle   speed\n",
                   options.name == "dam" ? "water" : "sand", gpu->device().name, options.steps,
                   std::min(SETTLED_STEPS, options.steps));
    }
    return reportRuns(
        options, presets, *gpu, std::min(SETTLED_STEPS, options.steps),
        [&](uint32_t blockCount, const Preset& preset) { return runOnce(*gpu, blockCount, preset, options); });
}

}  // namespace knuckle
