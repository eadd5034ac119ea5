#include <fmt/format.h>

#include <algorithm>

#include "app/bench/bench_run.h"
#include "app/bench/bench_worlds.h"
#include "render/renderer.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

/// The paper's table 2 [frames/s].
struct PaperRow {
    uint32_t objects;
    int quadroP6000, gtx1080, unreal;
};
constexpr PaperRow PAPER[] = {{300, 273, 233, 195}, {600, 133, 95, 95}, {1200, 40, 36, 39}};
constexpr uint32_t SETTLED_STEPS = 200;

/// @returns null if the paper has no such row.
const PaperRow* paperRow(uint32_t objects)
{
    const auto* row = std::find_if(std::begin(PAPER), std::end(PAPER),
                                   [&](const PaperRow& candidate) { return candidate.objects == objects; });
    return row == std::end(PAPER) ? nullptr : row;
}

struct BenchRun {
    std::string preset;
    uint32_t objectCount = 0;
    size_t particleCount = 0;
    double stepsPerSecond = 0.0, settledStepsPerSecond = 0.0, drawnStepsPerSecond = 0.0;
    float pileTop = 0.0f;  ///< Highest body centre [m].
    Measures measures;
    float diameter = 0.1f;
};

BenchRun runOnce(Gpu& gpu, uint32_t objectCount, const std::string& preset, const BenchOptions& options,
                 const Settings& settings)
{
    const World world = table2World(objectCount, settings);
    Solver solver(gpu, world);
    const InterruptGuard interrupt;
    const uint32_t settled = std::min(SETTLED_STEPS, options.steps);
    const auto nothing = [](uint32_t) {};
    const double falling = timeSteps(solver, interrupt, 1, options.steps - settled, nothing);
    const double resting = timeSteps(solver, interrupt, options.steps - settled + 1, settled, nothing);
    BenchRun run;
    run.preset = preset;
    run.objectCount = objectCount;
    run.particleCount = world.particles.size();
    run.diameter = world.diameter();
    run.stepsPerSecond = options.steps / (falling + resting);
    run.settledStepsPerSecond = settled / resting;
    run.measures = solver.measure();
    for (const BodyState& body : solver.readBodies()) run.pileTop = std::max(run.pileTop, body.position.y());
    if (options.drawnSteps > 0) {
        const RenderSettings picture;
        Renderer renderer(gpu, world, picture);
        const ParticleView view = solver.view();
        const double drawn = timeSteps(solver, interrupt, options.steps + 1, options.drawnSteps, [&](uint32_t step) {
            renderer.draw(view, step * static_cast<double>(world.settings.timeStep));
        });
        run.drawnStepsPerSecond = options.drawnSteps / drawn;
    }
    return run;
}

nlohmann::ordered_json published(const PaperRow* row)
{
    if (row == nullptr) return nullptr;
    return {{"quadroP6000", row->quadroP6000}, {"gtx1080", row->gtx1080}, {"unreal", row->unreal}};
}

nlohmann::ordered_json toJson(const BenchRun& run)
{
    nlohmann::ordered_json json = {{"preset", run.preset},
                                   {"objectCount", run.objectCount},
                                   {"particleCount", run.particleCount},
                                   {"stepsPerSecond", run.stepsPerSecond},
                                   {"settledStepsPerSecond", run.settledStepsPerSecond},
                                   {"drawnStepsPerSecond", run.drawnStepsPerSecond},
                                   {"pileTop", run.pileTop}};
    json.update(measuresToJson(run.measures, run.diameter));
    json["published"] = published(paperRow(run.objectCount));
    return json;
}

void printRow(const BenchRun& run)
{
    const PaperRow* paper = paperRow(run.objectCount);
    const std::string published = paper == nullptr
                                      ? fmt::format("{:>7}{:>7}{:>7}", "-", "-", "-")
                                      : fmt::format("{:7}{:7}{:7}", paper->quadroP6000, paper->gtx1080, paper->unreal);
    fmt::print("{:<8}{:7}{:11}{:9.1f}{:9.1f}{:9.1f}{}{:8.2f}{:9.1f}{:7.1f}{:9.1f}{:7.1f}{:7.2f}\n", run.preset,
               run.objectCount, run.particleCount, run.stepsPerSecond, run.settledStepsPerSecond,
               run.drawnStepsPerSecond, published, run.pileTop, 100 * run.measures.meanPenetration / run.diameter,
               100 * run.measures.worstPenetration / run.diameter, 100 * run.measures.meanJointGap / run.diameter,
               100 * run.measures.worstJointGap / run.diameter, run.measures.maxSpeed);
    std::fflush(stdout);
}

/// A step's work in the largest world for a software driver: one device, with its threads, serves all worlds.
Workload benchWorkload(const BenchOptions& options, const std::vector<Preset>& presets)
{
    const uint32_t most = *std::max_element(options.objects.begin(), options.objects.end());
    return stepWorkload(table2World(most, presets.back().second));
}

}  // namespace

int benchTable2(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common)
{
    const auto gpu = openGpu(common, FrameWork{benchWorkload(options, presets), {}});
    if (!options.json) {
        fmt::print("Table 2 on {}: {} steps of 1/60 s; steps/s of all, of the last {}, and drawn at 1280x720;\n"
                   "beside them the paper's frames/s; penetration and joint gap in % of a diameter; the fastest\n"
                   "particle at the end in m/s.\n\n"
                   "preset  objects  particles      all  settled    drawn  P6000   1080    UE4  top, m mean pen  worst "
                   "mean gap  worst  speed\n",
                   gpu->device().name, options.steps, SETTLED_STEPS);
    }
    return reportRuns(options, presets, *gpu, std::min(SETTLED_STEPS, options.steps),
                      [&](uint32_t objectCount, const Preset& preset) {
                          return runOnce(*gpu, objectCount, preset.first, options, preset.second);
                      });
}

}  // namespace knuckle
