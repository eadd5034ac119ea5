#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/bench/bench_run.h"
#include "app/bench/table2_world.h"
#include "app/commands/commands.h"
#include "app/files/assets.h"
#include "app/scene/scene_document.h"
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

int benchTable2(const BenchOptions& options, const std::vector<Preset>& presets, const CommonOptions& common)
{
    const auto gpu = openGpu(common, FrameWork{benchWorkload(options, presets), {}});
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
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
            const BenchRun run = runOnce(*gpu, objectCount, preset, options, settings);
            if (options.json) runs.push_back(toJson(run));
            else printRow(run);
        }
    }
    const uint32_t settled = std::min(SETTLED_STEPS, options.steps);
    if (options.json) fmt::print("{}\n", runsToJson(options, *gpu, settled, std::move(runs)).dump(2));
    return EXIT_FINE;
}

int bench(BenchOptions options, const CommonOptions& common)
{
    options.model = findAsset(options.model);
    const bool troupe = options.name == "troupe", draw = options.name == "draw", water = options.name == "water";
    if (options.objects.empty() && draw) options.objects = {25};
    if (options.objects.empty() && water) options.objects = {16};
    if (options.objects.empty() && troupe) options.objects = {100};
    if (options.objects.empty()) options.objects = {300, 600, 1200};
    if (draw) return benchDraw(options, common);
    if (water) return benchWater(options, common);
    std::vector<Preset> presets;
    for (const std::string& preset : options.presets) presets.emplace_back(preset, loadSettings(preset, options.sets));
    return troupe ? benchTroupe(options, presets, common) : benchTable2(options, presets, common);
}

}  // namespace

void addBenchCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand(
        "bench", "Time the solver (the paper's table 2, a troupe of actors) or the drawing of a crowd or water");
    command->fallthrough();
    command->footer(
        "table2: objects are pairs of 3x3x3 cubes with a joint, the four types in equal shares, dropped in\n"
        "layers into a 4 x 4 m box. troupe: objects are actors in that box, who walk on the spot for half of\n"
        "the steps and are limp for the rest. Penetration and gaps stand beside the speed, since a squashed\n"
        "pile is fast. draw: objects are actors who walk on the spot, drawn as spheres and in their skins.\n"
        "water: objects are blocks of 4096 particles of water, drawn as spheres and as a surface.\n\n"
        "Example:\n  knuckle bench table2 --objects 300,1200 --json\n"
        "  knuckle bench table2 --preset default,paper --objects 300\n"
        "  knuckle bench troupe\n"
        "  knuckle bench draw --objects 1,25,100\n"
        "  knuckle bench water --drawn-steps 20");
    auto options = std::make_shared<BenchOptions>();
    command->add_option("BENCHMARK", options->name, "What to run")
        ->check(CLI::IsMember({"table2", "troupe", "draw", "water"}))
        ->capture_default_str();
    command
        ->add_option("--objects", options->objects,
                     "Numbers of objects [300,600,1200; troupe: 100; draw: 25; water: 16]")
        ->delimiter(',')
        ->check(CLI::Range(1, 10000));
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
    command
        ->add_option("--drawn-steps", options->drawnSteps,
                     "Further steps of table2 that are drawn as well, 0 for none; frames of draw and water")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command->add_option("--model", options->model, "The figure of troupe and draw; it has a clip \"walk\"")
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON instead of the table, docs/output.md");
    command->callback([=] { line.chosen = [=] { return bench(*options, line.common); }; });
}

}  // namespace knuckle
