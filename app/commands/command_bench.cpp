#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/table2_world.h"
#include "app/run/interrupt.h"
#include "app/scene/scene_file.h"
#include "render/renderer.h"
#include "sim/solver/solver.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

struct BenchOptions {
    std::string name = "table2";
    std::vector<std::string> presets = {"default"}, sets;
    std::vector<uint32_t> objects = {300, 600, 1200};
    uint32_t steps = 600, drawnSteps = 60;
    bool json = false;
};

/// The paper's table 2 [frames/s].
struct PaperRow {
    uint32_t objects;
    int quadroP6000, gtx1080, unreal;
};
constexpr PaperRow PAPER[] = {{300, 273, 233, 195}, {600, 133, 95, 95}, {1200, 40, 36, 39}};
constexpr uint32_t SETTLED_STEPS = 200;

/// @returns null where the paper has no such row.
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

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
        Renderer renderer(gpu, world, {});
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
    return {{"preset", run.preset},
            {"objectCount", run.objectCount},
            {"particleCount", run.particleCount},
            {"stepsPerSecond", run.stepsPerSecond},
            {"settledStepsPerSecond", run.settledStepsPerSecond},
            {"drawnStepsPerSecond", run.drawnStepsPerSecond},
            {"pileTop", run.pileTop},
            {"meanPenetration", run.measures.meanPenetration / run.diameter},
            {"worstPenetration", run.measures.worstPenetration / run.diameter},
            {"meanJointGap", run.measures.meanJointGap / run.diameter},
            {"worstJointGap", run.measures.worstJointGap / run.diameter},
            {"worstShapeError", run.measures.worstShapeError / run.diameter},
            {"maxSpeed", run.measures.maxSpeed},
            {"published", published(paperRow(run.objectCount))}};
}

/// All runs, with what they have in common; docs/output.md describes each key.
nlohmann::ordered_json toJson(const BenchOptions& options, const Gpu& gpu, const std::vector<BenchRun>& runs)
{
    nlohmann::ordered_json result = {{"benchmark", options.name},
                                     {"device", gpu.device().name},
                                     {"driverThreads", nullptr},
                                     {"steps", options.steps},
                                     {"settledSteps", std::min(SETTLED_STEPS, options.steps)},
                                     {"drawnSteps", options.drawnSteps},
                                     {"runs", nlohmann::ordered_json::array()}};
    if (gpu.threads().count) result["driverThreads"] = *gpu.threads().count;
    for (const BenchRun& run : runs) result["runs"].push_back(toJson(run));
    return result;
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

/// What a step of the largest world asks of a software driver: one device, with its threads, serves all worlds.
Workload benchWorkload(const BenchOptions& options, const std::vector<std::pair<std::string, Settings>>& presets)
{
    const uint32_t most = *std::max_element(options.objects.begin(), options.objects.end());
    return stepWorkload(table2World(most, presets.back().second));
}

int bench(const BenchOptions& options, const CommonOptions& common)
{
    std::vector<std::pair<std::string, Settings>> presets;
    for (const std::string& preset : options.presets) presets.emplace_back(preset, loadSettings(preset, options.sets));
    const auto gpu = openGpu(common, FrameWork{benchWorkload(options, presets), {}});
    std::vector<BenchRun> runs;
    if (!options.json) {
        fmt::print("Table 2 on {}: {} steps of 1/60 s; steps/s of all, of the last {}, and drawn at 1280x720;\n"
                   "beside them the paper's frames/s; penetration and joint gap in % of a diameter; the fastest\n"
                   "particle at the end in m/s.\n\n"
                   "preset  objects  particles      all  settled    drawn  P6000   1080    UE4  top, m mean pen  worst "
                   "mean gap  worst  speed\n",
                   gpu->device().name, options.steps, SETTLED_STEPS);
    }
    for (uint32_t objectCount : options.objects) {
        for (const auto& [preset, settings] : presets) {
            runs.push_back(runOnce(*gpu, objectCount, preset, options, settings));
            if (!options.json) printRow(runs.back());
        }
    }
    if (options.json) fmt::print("{}\n", toJson(options, *gpu, runs).dump(2));
    return EXIT_FINE;
}

}  // namespace

void addBenchCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("bench", "Time the solver on the paper's table 2");
    command->fallthrough();
    command->footer(
        "Objects are pairs of 3x3x3 cubes with a joint, the four types in equal shares, dropped in layers\n"
        "into a 4 x 4 m box. Penetration and gaps stand beside the speed, since a squashed pile is fast.\n\n"
        "Example:\n  knuckle bench table2 --objects 300,1200 --json\n"
        "  knuckle bench table2 --preset default,paper --objects 300");
    auto options = std::make_shared<BenchOptions>();
    command->add_option("BENCHMARK", options->name, "What to run")
        ->check(CLI::IsMember({"table2"}))
        ->capture_default_str();
    command->add_option("--objects", options->objects, "Numbers of objects")
        ->delimiter(',')
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->add_option("--preset", options->presets, "Solver presets, each with every number of objects")
        ->delimiter(',')
        ->check(CLI::IsMember({"default", "paper"}))
        ->capture_default_str();
    command->add_option("--set", options->sets, "Change a field of the solver, for instance solver.iterations=8")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--steps", options->steps, "Steps of 1/60 s")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--drawn-steps", options->drawnSteps, "Further steps that are drawn as well, 0 for none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON instead of the table, docs/output.md");
    command->callback([=] { line.chosen = [=] { return bench(*options, line.common); }; });
}

}  // namespace knuckle
