#include "app/bench/bench_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench/bench_run.h"
#include "app/bench/bench_worlds.h"
#include "sim/base/errors.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

constexpr double PAIR_LAYERS = 4.0, COLUMN_LAYERS = 16.0;
/// Further steps, of which each pass is timed by itself.
constexpr uint32_t PASS_STEPS = 5;

struct ScaleRun {
    std::string world;
    size_t particleCount = 0;
    uint32_t substeps = 0;
    double milliseconds = 0.0;  ///< A step, the median.
    uint64_t bufferBytes = 0;
    std::vector<PassTime> passes = {};  ///< Of PASS_STEPS steps.
    std::string problem = {};           ///< Why it has not run; empty: it has.

    double perParticle(double sum) const { return sum / static_cast<double>(particleCount); }
};

/// As high at each size, so that only the area grows.
World worldOf(const std::string& name, uint32_t particles)
{
    if (name != "pairs") {
        const int side = std::max(static_cast<int>(std::lround(std::sqrt(particles / COLUMN_LAYERS))), 1);
        const Eigen::Vector3i counts(side, static_cast<int>(COLUMN_LAYERS), side);
        return name == "dam" ? damWorld(counts) : sandWorld(counts);
    }
    // Layers of columns x 2 columns.
    const double columns = std::max(1.0, std::round(std::sqrt(particles / (2.0 * PAIR_LAYERS * PAIR_PARTICLES))));
    return pairsWorld(static_cast<uint32_t>(2.0 * PAIR_LAYERS * columns * columns), static_cast<uint32_t>(columns));
}

void runOn(Gpu& gpu, const World& world, const ScaleOptions& options, ScaleRun& run)
{
    Solver solver(gpu, world);
    const InterruptGuard interrupt;
    const auto seconds = [&](uint32_t first, uint32_t count) {
        return timeSteps(solver, interrupt, first + 1, count, [](uint32_t) {});
    };
    seconds(0, options.settling);
    std::vector<double> times;
    for (uint32_t k = 0; k < options.steps; ++k) times.push_back(seconds(options.settling + k, 1));
    run.milliseconds = 1e3 * medianOf(times);
    run.bufferBytes = solver.bufferBytes();
    solver.timePasses();
    seconds(options.settling + options.steps, PASS_STEPS);
    run.passes = solver.passTimes();
}

/// A world that is too large for the device is a result, too.
ScaleRun runOnce(Gpu& gpu, const std::string& name, uint32_t particles, const ScaleOptions& options)
{
    const World world = worldOf(name, particles);
    ScaleRun run{.world = name, .particleCount = world.particles.size(), .substeps = world.settings.substeps};
    try {
        runOn(gpu, world, options, run);
    } catch (const DeviceError& error) {
        run.problem = error.what();
    }
    return run;
}

nlohmann::ordered_json toJson(const ScaleRun& run)
{
    nlohmann::ordered_json json = {
        {"world", run.world}, {"particleCount", run.particleCount}, {"substeps", run.substeps}, {"problem", nullptr}};
    if (!run.problem.empty()) {
        json["problem"] = run.problem;
        return json;
    }
    json["milliseconds"] = run.milliseconds;
    json["microsecondsPerParticle"] = run.perParticle(1e3 * run.milliseconds);
    json["bufferBytes"] = run.bufferBytes;
    json["bytesPerParticle"] = run.perParticle(static_cast<double>(run.bufferBytes));
    nlohmann::ordered_json& passes = json["passes"] = nlohmann::ordered_json::array();
    for (const PassTime& pass : run.passes)
        passes.push_back({{"name", pass.name}, {"milliseconds", pass.milliseconds / PASS_STEPS}});
    return json;
}

void printRow(const ScaleRun& run)
{
    fmt::print("{:<6}{:10}{:10}", run.world, run.particleCount, run.substeps);
    if (run.problem.empty())
        fmt::print("{:10.2f}{:13.3f}{:9.1f}{:16.0f}\n", run.milliseconds, run.perParticle(1e3 * run.milliseconds),
                   static_cast<double>(run.bufferBytes) / (1 << 20),
                   run.perParticle(static_cast<double>(run.bufferBytes)));
    else fmt::print("  {}\n", run.problem);
    std::fflush(stdout);
}

}  // namespace

int benchScale(const ScaleOptions& options, const CommonOptions& common)
{
    const uint32_t most = *std::ranges::max_element(options.particles);
    const auto gpu = openGpu(common, FrameWork{stepWorkload(worldOf(options.worlds.back(), most)), {}});
    if (!options.json)
        fmt::print(
            "Jointed pairs on the floor, four layers, and columns of water and sand that break, on {}:\n"
            "the median of {} steps of 1/60 s after {}, ms and us a particle; MiB of buffers, bytes a particle.\n\n"
            "world  particles  substeps   ms/step  us/particle      MiB  bytes/particle\n",
            gpu->device().name, options.steps, options.settling);
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const std::string& world : options.worlds)
        for (const uint32_t particles : options.particles) {
            const ScaleRun run = runOnce(*gpu, world, particles, options);
            if (options.json) runs.push_back(toJson(run));
            else printRow(run);
        }
    BenchOptions shown;
    shown.name = "scale";
    shown.steps = options.steps;
    shown.drawnSteps = 0;
    if (options.json) fmt::print("{}\n", runsToJson(shown, *gpu, options.steps, std::move(runs)).dump(2));
    return EXIT_FINE;
}

}  // namespace knuckle
