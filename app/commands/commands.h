#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim/gpu/gpu.h"

namespace CLI {
class App;
}

namespace knuckle {

/// Options that every command takes.
struct CommonOptions {
    std::string device = "auto";
    std::string shaderFolder;
    bool quiet = false;
};

/// What a command needs to register itself. Its callback sets `chosen` to the function that runs it and returns the
/// exit code.
struct CommandLine {
    CLI::App& program;
    const CommonOptions& common;
    std::function<int()>& chosen;
};

enum ExitCode {
    EXIT_FINE = 0,
    EXIT_RUN = 1,
    EXIT_INPUT = 2,
    EXIT_DEVICE = 3,
    EXIT_DIFFERENT = 4,
    EXIT_INTERRUPTED = 130,
};

void addRenderCommand(CommandLine line);
void addVoxelizeCommand(CommandLine line);
void addCheckCommand(CommandLine line);
void addCompareCommand(CommandLine line);
void addBenchCommand(CommandLine line);
void addInfoCommand(CommandLine line);
void addSchemaCommand(CommandLine line);

/// The whole program: reads the command line, runs the command, tells errors on stderr. @returns the exit code.
int runProgram(int argc, char** argv);

/// The device that `--device` names; says on stderr what had to be chosen instead. @throws DeviceError, InputError.
/// @param work of a frame, by which a software renderer gets its threads, else they are left to it.
std::unique_ptr<Gpu> openGpu(const CommonOptions& common, std::optional<FrameWork> work = {});

}  // namespace knuckle
