#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/bench/bench_compare.h"
#include "app/bench/bench_run.h"
#include "app/bench/bench_scale.h"
#include "app/bench/trials.h"
#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/files/assets.h"
#include "app/scene/scene_document.h"

namespace knuckle {

namespace {

/// Benchmarks that `bench` runs by name, and their numbers of objects.
struct Benchmark {
    const char* name;
    std::vector<uint32_t> objects;
};
const std::vector<Benchmark>& benchmarks()
{
    static const std::vector<Benchmark> all = {
        {"table2", {300, 600, 1200}}, {"troupe", {100}}, {"dam", {4}}, {"sand", {4}}, {"draw", {25}}, {"water", {16}}};
    return all;
}

std::vector<std::string> benchmarkNames()
{
    std::vector<std::string> names;
    for (const Benchmark& benchmark : benchmarks()) names.emplace_back(benchmark.name);
    return names;
}

int bench(BenchOptions options, const CommonOptions& common)
{
    options.model = findAsset(options.model);
    if (options.objects.empty())
        options.objects = std::ranges::find(benchmarks(), options.name, &Benchmark::name)->objects;
    if (options.name == "draw") return benchDraw(options, common);
    if (options.name == "water") return benchWater(options, common);
    std::vector<Preset> presets;
    for (const std::string& preset : options.presets) presets.emplace_back(preset, loadSettings(preset, options.sets));
    if (options.name == "troupe") return benchTroupe(options, presets, common);
    return options.name == "table2" ? benchTable2(options, presets, common) : benchColumn(options, presets, common);
}

constexpr const char* NOTES =
    "table2: objects are pairs of 3x3x3 cubes with a joint, the four types in equal shares, dropped in\n"
    "layers into a 4 x 4 m box. troupe: objects are actors in that box, who walk on the spot for half of\n"
    "the steps and are limp for the rest. Penetration and gaps stand beside the speed, since a squashed\n"
    "pile is fast. dam, sand: objects are blocks of 4096 particles in a column that breaks. draw: objects\n"
    "are actors who walk on the spot, drawn as spheres and in their skins. water: objects are blocks of\n"
    "4096 particles of water, drawn as spheres and as a surface.\n\n"
    "Examples:\n"
    "  knuckle bench table2 --objects 300,1200 --json\n"
    "  knuckle bench table2 --preset default,paper --objects 300\n"
    "  knuckle bench troupe\n"
    "  knuckle bench dam --steps 120\n"
    "  knuckle bench draw --objects 1,25,100\n"
    "  knuckle bench water --drawn-steps 20\n"
    "  knuckle bench compare old/knuckle build/release/bin/knuckle\n"
    "  knuckle bench scale --particles 16000,65000";

void addCompare(CLI::App& bench, CommandLine line)
{
    auto* command = bench.add_subcommand("compare", "Which of two knuckle programs is faster, and by how much");
    command->fallthrough();
    command->footer(
        "Both are run in turn, so that a machine that changes its speed affects both alike. Of the ratios of their\n"
        "times, round by round, the median is told, and an interval that holds the true one with 95 % or more,\n"
        "however times scatter: from the k-th smallest to the k-th largest, by the binomial distribution. A first\n"
        "run of each does not count. Exit code 0 whichever is faster.\n\n"
        "Examples:\n"
        "  knuckle bench compare old/knuckle build/release/bin/knuckle\n"
        "  knuckle bench compare A B --bench table2,sand --rounds 15\n"
        "  knuckle bench compare A B --bench cold,warm --json");
    auto options = std::make_shared<CompareProgramsOptions>();
    std::vector<std::string> names, first;
    for (const Trial& trial : trials()) {
        names.push_back(trial.name);
        if (trial.byDefault) first.push_back(trial.name);
    }
    command->add_option("A", options->a, "A knuckle program")->required();
    command->add_option("B", options->b, "Another, or the same")->required();
    command
        ->add_option("--bench", options->trials,
                     fmt::format("What is measured: {}; of these cold and warm: the first frame of hello.json, without "
                                 "and with shaders compiled before [{}]",
                                 fmt::join(names, ","), fmt::join(first, ",")))
        ->delimiter(',')
        ->check(oneOf(names))
        ->type_name("NAME,...");
    command->add_option("--rounds", options->rounds, "How often each is run")
        ->check(CLI::Range(FEWEST_PAIRS, 1000))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON instead of the table, docs/output.md");
    command->callback([=] { line.chosen = [=] { return benchCompare(*options, line.common); }; });
}

void addScale(CLI::App& bench, CommandLine line)
{
    auto* command = bench.add_subcommand("scale", "Time and memory of a step at growing numbers of particles");
    command->fallthrough();
    command->footer(
        "pairs: those of table2, four layers on a floor that grows. dam: a column of water, 16 particles high, that\n"
        "breaks. sand: the same of grains. The number of particles is the nearest that such a world can have. A world\n"
        "that does not fit the device is told. With the software driver, a million particles take some seconds a "
        "step.\n\n"
        "Examples:\n"
        "  knuckle bench scale\n"
        "  knuckle bench scale --particles 16000,65000 --world dam\n"
        "  knuckle bench scale --particles 1000000 --settle 5 --steps 5 --json");
    auto options = std::make_shared<ScaleOptions>();
    command->add_option("--particles", options->particles, "Sizes")
        ->delimiter(',')
        ->check(CLI::Range(100, 16000000))
        ->capture_default_str();
    command->add_option("--world", options->worlds, "What is simulated")
        ->delimiter(',')
        ->check(CLI::IsMember({"pairs", "dam", "sand"}))
        ->capture_default_str();
    command->add_option("--settle", options->settling, "Steps of 1/60 s before those that are timed")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command->add_option("--steps", options->steps, "Steps that are timed")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON instead of the table, docs/output.md");
    command->callback([=] { line.chosen = [=] { return benchScale(*options, line.common); }; });
}

}  // namespace

void addBenchCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand(
        "bench", "Time the solver or the drawing, at any size; compare the speed of two programs");
    command->fallthrough();
    command->footer(NOTES);
    addCompare(*command, line);
    addScale(*command, line);
    auto options = std::make_shared<BenchOptions>();
    command->add_option("BENCHMARK", options->name, "What to run")
        ->check(CLI::IsMember(benchmarkNames()))
        ->capture_default_str();
    command
        ->add_option("--objects", options->objects,
                     "Numbers of objects [300,600,1200; troupe: 100; dam, sand: 4; draw: 25; water: 16]")
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
    command->callback([=] {
        if (command->get_subcommands().empty()) line.chosen = [=] { return bench(*options, line.common); };
    });
}

}  // namespace knuckle
