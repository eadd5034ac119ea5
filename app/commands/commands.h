#pragma once

#include <exception>
#include <functional>

#include "app/completion/command_facts.h"
#include "app/run/exit_codes.h"
#include "app/run/open_gpu.h"

namespace CLI {
class App;
}

namespace knuckle {

/// What a command needs to register itself. Its callback sets `chosen` to the function that runs it and returns the
/// exit code.
struct CommandLine {
    CLI::App& program;
    const CommonOptions& common;
    std::function<int()>& chosen;
};

void addRenderCommand(CommandLine line);
void addVoxelizeCommand(CommandLine line);
void addCheckCommand(CommandLine line);
void addCompareCommand(CommandLine line);
void addBenchCommand(CommandLine line);
void addGoldenCommand(CommandLine line);
void addInfoCommand(CommandLine line);
void addDoctorCommand(CommandLine line);
void addServeCommand(CommandLine line);
void addSweepCommand(CommandLine line);
void addSchemaCommand(CommandLine line);
void addCompletionCommand(CommandLine line);
void addManualCommand(CommandLine line);

/// What the option tables say, of a command and those below it.
CommandFacts factsOf(CLI::App& command);

/// Prints one line about what ended a command. @returns its exit code.
int tellFailure(const std::exception_ptr& failure);

/// The whole program: reads the command line, runs the command, prints errors to stderr. @returns the exit code.
int runProgram(int argc, char** argv);

}  // namespace knuckle
