#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/run/counted.h"
#include "app/run/shell_command.h"
#include "app/sweep/child.h"
#include "app/sweep/sweep.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr uint64_t TASKS = 16;
constexpr const char *NO_OPTIONS = "none", *NAME = "sweep.sbatch";

std::string absolute(const std::string& path)
{
    std::error_code ignored;
    return fs::absolute(path, ignored).lexically_normal().string();
}

/// What each task of the array runs. It takes the place of the shell, so that signals reach it.
std::string workerLine(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common)
{
    std::vector<std::string> words{ownProgram(), "--device", common.device};
    if (!common.shaderFolder.empty()) words.insert(words.end(), {"--shaders", absolute(common.shaderFolder)});
    words.insert(words.end(),
                 {"sweep", absolute(sweep.plan.path), "-o", absolute(sweep.folder), "--leave", "--tries",
                  std::to_string(options.watch.tries), "--stale", fmt::format("{}", options.watch.staleSeconds)});
    std::string line = "exec";
    for (const std::string& word : words) line += " " + quotedForShell(word);
    return line;
}

std::string scriptOf(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common)
{
    const uint64_t tasks = std::min<uint64_t>(options.jobs == 0 ? TASKS : options.jobs, sweep.runs.size());
    std::string text = "#!/bin/sh\n";
    const auto add = [&text](const std::string& option) { text += "#SBATCH " + option + "\n"; };
    add(fmt::format("--job-name=\"{}\"", sweep.plan.name));
    add(fmt::format("--array=1-{}", tasks));
    add(fmt::format("--output=\"{}/slurm_%a.log\"", absolute(sweep.folder)));
    add("--open-mode=append");
    add("--requeue");
    add("--signal=B:TERM@60");
    if (options.slurm != NO_OPTIONS) add(options.slurm);
    return text + workerLine(sweep, options, common) + "\n";
}

}  // namespace

void submitToSlurm(const Sweep& sweep, const SweepOptions& options, const CommonOptions& common)
{
    for (const std::string& text : {options.slurm, sweep.plan.name, sweep.folder})
        if (text.find_first_of("\n\r\"") != std::string::npos)
            throw InputError("--slurm: options, the plan's name and its folder must be one line each, without quotes");
    sweep.open();
    const std::string path = sweep.folder + "/" + NAME;
    writeFile(path, scriptOf(sweep, options, common));
    const ShellResult result = runShell("sbatch --parsable " + quotedForShell(absolute(path)), ".");
    if (!result.failure.empty())
        throw InputError(fmt::format("--slurm: sbatch {}: {}; {} is written, and can be submitted by hand",
                                     result.failure, result.lastLine, path));
    if (!common.quiet)
        fmt::print("{} as job {} of Slurm; `knuckle sweep status {}` says how far they are\n",
                   counted(sweep.runs.size(), "run"), result.lastLine, sweep.plan.path);
}

}  // namespace knuckle
