#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/json/json.h"
#include "app/run/crash.h"
#include "app/run/interrupt.h"
#include "app/run/tell.h"
#include "sim/base/errors.h"
#include "sim/base/memory.h"

namespace knuckle {

namespace {

constexpr const char* EXAMPLES =
    "Examples:\n"
    "  knuckle render assets/scenes/ragdoll.json               frames in out/ragdoll\n"
    "  knuckle render assets/scenes/pile.json -o pile.mp4      a film\n"
    "  knuckle voxelize model.glb -o actor.json --diameter 0.04\n"
    "  knuckle check assets/scenes/*.json\n"
    "  knuckle serve assets/scenes/pile.json                   live, in a browser: http://127.0.0.1:8080\n"
    "  knuckle sweep plan.json --jobs 4                        a scene many times, with other values\n"
    "  knuckle doctor                                          what this machine lacks\n"
    "\n"
    "Exit codes:\n"
    "  0 done   1 the run failed (disk full, state became invalid)   2 bad input or options\n"
    "  3 no usable OpenGL 4.3 device   4 images or states differ (compare, golden)   130 stopped by Ctrl-C\n";

constexpr const char* NO_THREAD =
    "the system gives no more threads or processes; allow more (ulimit -u; of a container "
    "--pids-limit); `knuckle doctor` says more";

void addCommonOptions(CLI::App& program, CommonOptions& common)
{
    program
        .add_option("--device", common.device,
                    "Where to compute: auto (a GPU, else the CPU), gpu, software, or a number of `knuckle info`")
        ->capture_default_str()
        ->type_name("NAME")
        ->check(offered({"auto", "gpu", "software"}));
    program.add_option("--shaders", common.shaderFolder, "Take shaders from this folder before the built-in ones")
        ->type_name("DIR");
    program.add_flag("--quiet,-q", common.quiet, "Print errors only");
}

/// @throws InputError for a line with a word that should be a command.
void refuseUnknownCommand(const CLI::App& program)
{
    const std::vector<std::string> left = program.remaining();
    if (left.empty() || left[0].starts_with('-') || !program.get_subcommands().empty()) return;
    std::vector<std::string> commands;
    for (const CLI::App* command : program.get_subcommands({})) commands.push_back(command->get_name());
    throw InputError(fmt::format("{} is no command; {}; see knuckle --help", left[0], suggestion(left[0], commands)));
}

int parseAndRun(int argc, char** argv)
{
    CommonOptions common;
    std::function<int()> chosen;
    CLI::App program("Knuckle turns rigged meshes into ragdolls made of particles, simulates them in OpenGL compute "
                     "shaders and films them. No window and no GPU are needed.",
                     "knuckle");
    program.set_version_flag("--version", "knuckle " KNUCKLE_VERSION);
    program.require_subcommand(1);
    program.footer(EXAMPLES);
    program.get_formatter()->column_width(34);
    addCommonOptions(program, common);
    const CommandLine line{program, common, chosen};
    for (const auto add : {addRenderCommand, addVoxelizeCommand, addCheckCommand, addCompareCommand, addGoldenCommand,
                           addBenchCommand, addInfoCommand, addDoctorCommand, addServeCommand, addSweepCommand,
                           addSchemaCommand, addCompletionCommand, addManualCommand}) {
        add(line);
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        refuseUnknownCommand(program);
        throw InputError(fmt::format("{}; see knuckle --help", error.what()));
    }
    refuseEmptyValues(program);
    return chosen();
}

/// Prints the error. Never throws: if stderr is closed, there is no way left to report that.
int tell(const std::string& message, int code)
{
    try {
        tellUser("knuckle: " + message);
    } catch (const std::system_error&) {
    }
    return code;
}

/// Ends silently by SIGPIPE when the reader of our output has closed its pipe, as other filters (cat, grep) do.
int endByBrokenPipe()
{
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    return EXIT_RUN;
}

}  // namespace

int tellFailure(const std::exception_ptr& failure)
{
    try {
        std::rethrow_exception(failure);
    } catch (const InputError& error) {
        return tell(error.what(), EXIT_INPUT);
    } catch (const DeviceError& error) {
        return tell(error.what(), EXIT_DEVICE);
    } catch (const Interrupted&) {
        return tell("stopped; what was finished is kept", EXIT_INTERRUPTED);
    } catch (const std::bad_alloc&) {
        return tell(memoryMessage(), EXIT_RUN);
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::broken_pipe) return endByBrokenPipe();
        if (error.code() != std::errc::resource_unavailable_try_again) return tell(error.what(), EXIT_RUN);
        return tell(isMemoryShort() ? memoryMessage() : NO_THREAD, EXIT_RUN);
    } catch (const std::exception& error) {
        return tell(error.what(), EXIT_RUN);
    }
}

int runProgram(int argc, char** argv)
{
    std::signal(SIGPIPE, SIG_IGN);  // a closed reader becomes a write error, so that the program can clean up first
    saveAddressSpace();
    tellCrashesForWantOfMemory();
    endOnSignals();
    try {
        const int code = parseAndRun(argc, argv);
        flushStandardOutput();
        return code;
    } catch (...) {
        return tellFailure(std::current_exception());
    }
}

}  // namespace knuckle
