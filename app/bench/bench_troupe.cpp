#include <fmt/format.h>

#include <algorithm>

#include "app/bench/bench_run.h"
#include "app/bench/troupe_world.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

constexpr uint32_t SETTLED_STEPS = 200;

struct TroupeRun {
    std::string preset;
    uint32_t actorCount = 0;
    size_t particleCount = 0, bodyCount = 0;
    double animatedMilliseconds = 0.0, limpMilliseconds = 0.0, settledMilliseconds = 0.0;  ///< A step.
    float top = 0.0f;  ///< Highest body centre at the end [m].
    Measures measures;
    float diameter = 0.0f;
};

World worldOf(uint32_t actorCount, const BenchOptions& options, const Settings& settings)
{
    const uint32_t half = options.steps / 2;
    return troupeWorld(actorCount, static_cast<float>(half) * settings.timeStep, options.model, settings);
}

TroupeRun runOnce(Gpu& gpu, uint32_t actorCount, const Preset& preset, const BenchOptions& options)
{
    const World world = worldOf(actorCount, options, preset.second);
    Solver solver(gpu, world);
    const InterruptGuard interrupt;
    const uint32_t animated = options.steps / 2, limp = options.steps - animated;
    const uint32_t settled = std::min(SETTLED_STEPS, limp);
    const auto seconds = [&](uint32_t first, uint32_t count) {
        return count == 0 ? 0.0 : timeSteps(solver, interrupt, first + 1, count, [](uint32_t) {});
    };
    const double dancing = seconds(0, animated), falling = seconds(animated, limp - settled),
                 resting = seconds(options.steps - settled, settled);
    TroupeRun run;
    run.preset = preset.first;
    run.actorCount = actorCount;
    run.particleCount = world.particles.size();
    run.bodyCount = world.bodies.size();
    run.animatedMilliseconds = 1e3 * dancing / std::max(animated, 1u);
    run.limpMilliseconds = 1e3 * (falling + resting) / limp;
    run.settledMilliseconds = 1e3 * resting / settled;
    run.measures = solver.measure();
    run.diameter = world.diameter();
    for (const BodyState& body : solver.readBodies()) run.top = std::max(run.top, body.position.y());
    return run;
}

nlohmann::ordered_json toJson(const TroupeRun& run)
{
    nlohmann::ordered_json json = {{"preset", run.preset},
                                   {"objectCount", run.actorCount},
                                   {"particleCount", run.particleCount},
                                   {"bodyCount", run.bodyCount},
                                   {"animatedMilliseconds", run.animatedMilliseconds},
                                   {"limpMilliseconds", run.limpMilliseconds},
                                   {"settledMilliseconds", run.settledMilliseconds},
                                   {"pileTop", run.top}};
    json.update(measuresToJson(run.measures, run.diameter));
    return json;
}

void printRow(const TroupeRun& run)
{
    const auto percent = [&](float length) { return 100 * length / run.diameter; };
    fmt::print("{:<8}{:6}{:11}{:8}{:10.2f}{:8.2f}{:9.2f}{:8.2f}{:10.1f}{:7.1f}{:10.1f}{:7.1f}{:7.2f}\n", run.preset,
               run.actorCount, run.particleCount, run.bodyCount, run.animatedMilliseconds, run.limpMilliseconds,
               run.settledMilliseconds, run.top, percent(run.measures.meanPenetration),
               percent(run.measures.worstPenetration), percent(run.measures.meanJointGap),
               percent(run.measures.worstJointGap), run.measures.maxSpeed);
    std::fflush(stdout);
}

}  // namespace

int benchTroupe(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common)
{
    const uint32_t most = *std::max_element(options.objects.begin(), options.objects.end());
    const uint32_t settled = std::min(SETTLED_STEPS, options.steps - options.steps / 2);
    const auto gpu = openGpu(common, FrameWork{stepWorkload(worldOf(most, options, presets.back().second)), {}});
    if (!options.json) {
        fmt::print("A troupe on {}: {} steps of 1/60 s, animated for the first half; ms a step of both halves and of\n"
                   "the last {}; at the end: the highest body, penetration and joint gap in % of a diameter, the\n"
                   "fastest particle in m/s.\n\n"
                   "preset  actors  particles  bodies  animated    limp  settled  top, m  mean pen  worst  mean gap  "
                   "worst  speed\n",
                   gpu->device().name, options.steps, settled);
    }
    return reportRuns(options, presets, *gpu, settled, [&](uint32_t actorCount, const Preset& preset) {
        return runOnce(*gpu, actorCount, preset, options);
    });
}

}  // namespace knuckle
