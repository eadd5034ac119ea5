#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/sweep/sweep.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr const char* SWEEP_NOTES =
    "A plan names a scene, fields with their values or ranges, and how many runs; `knuckle schema sweep` prints what "
    "it\n"
    "may have. Each run has a folder of its own. Any number of these commands, on any machines that see the folder, "
    "work\non the same sweep: each takes runs that nobody has, and goes on from the checkpoint of what was killed.\n\n"
    "Exit codes: 0 all runs are done, 1 some have failed, 2 bad input, 130 stopped; the same command goes on.\n\n"
    "Examples:\n"
    "  knuckle sweep throws.json --jobs 4\n"
    "  knuckle sweep throws.json --slurm --jobs 32              as an array of 32 tasks\n"
    "  knuckle sweep throws.json --slurm='--partition=long --time=4:00:00'\n"
    "  knuckle sweep status throws.json\n"
    "  knuckle sweep collect throws.json                        out/throws/table.csv and index.html\n\n"
    "docs/sweep.md has more.";

struct SweepWords {
    SweepOptions options;
    bool json = false;
};

int work(const SweepOptions& options, const CommonOptions& common)
{
    if (options.plan.empty()) throw InputError("PLAN is required; see knuckle sweep --help");
    const Sweep sweep = Sweep::read(options);
    if (!options.leave) checkScene(sweep.plan, sweep.runs);  // tasks of Slurm: when it was given to it
    if (options.slurm.empty()) workOn(sweep, options, common);
    else submitToSlurm(sweep, options, common);
    return EXIT_FINE;
}

void addPlan(CLI::App& command, SweepOptions& options)
{
    command.add_option("PLAN", options.plan, "A plan of runs, see docs/sweep.md");
    command.add_option("-o,--output", options.folder, "The folder of the sweep [out/NAME]")->type_name("DIR");
    command
        .add_option("--stale", options.watch.staleSeconds,
                    "Who has not been heard of for so long on another machine counts as gone [120]")
        ->type_name("SECONDS")
        ->check(numberBetween(1.0, 1e6));
    command.add_option("--tries", options.watch.tries, "How often a run may fail [3]")
        ->type_name("N")
        ->check(numberBetween(1.0, 1e6));
}

void addStatus(CLI::App& sweep, CommandLine line)
{
    auto* command = sweep.add_subcommand("status", "How many runs are done, who works, what has failed");
    auto words = std::make_shared<SweepWords>();
    command->fallthrough();
    addPlan(*command, words->options);
    command->get_option("PLAN")->required();
    command->add_flag("--json", words->json, "As JSON, each run");
    command->callback([=] {
        line.chosen = [=] {
            printStatus(Sweep::read(words->options), words->options.watch, words->json);
            return EXIT_FINE;
        };
    });
}

void addCollect(CLI::App& sweep, CommandLine line)
{
    auto* command = sweep.add_subcommand("collect",
                                         "Make a table and a page of all runs; exit code 1 if any is missing");
    auto options = std::make_shared<SweepOptions>();
    command->fallthrough();
    addPlan(*command, *options);
    command->get_option("PLAN")->required();
    command->callback([=] {
        line.chosen = [=] {
            collectSweep(Sweep::read(*options), options->watch, line.common.quiet);
            return EXIT_FINE;
        };
    });
}

}  // namespace

void addSweepCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("sweep", "Run a scene many times, on one machine or a farm");
    command->fallthrough();
    command->footer(SWEEP_NOTES);
    auto options = std::make_shared<SweepOptions>();
    addPlan(*command, *options);
    command->add_option("--jobs", options->jobs, "So many runs at once [1]; with --slurm tasks of the array [16]")
        ->type_name("N")
        ->check(numberBetween(1.0, 1e5));
    command->add_flag(
        "--leave", options->leave,
        "End when all that is left is in the hands of others, instead of waiting in case they are killed");
    command->add_flag("--slurm{none}", options->slurm,
                      "Submit the runs as an array of tasks; --slurm='--partition=long': with these options of sbatch");
    addStatus(*command, line);
    addCollect(*command, line);
    command->callback([=] {
        if (!command->get_subcommands().empty()) return;
        line.chosen = [=] { return work(*options, line.common); };
    });
}

}  // namespace knuckle
