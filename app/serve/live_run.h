#pragma once

#include <string>

#include "app/run/open_gpu.h"
#include "app/serve/served_scene.h"
#include "app/serve/web/web_server.h"

namespace knuckle {

struct ServeOptions {
    WebOptions web;
    double share = 0.05;  ///< Of the time, which pictures may take from a simulation that is behind, 0.01 ... 1.
    bool hash = false;    ///< Prints the last state's.
    std::string log;      ///< A file for all that changes the simulation; empty: none.
    std::string replay;   ///< One of them: replayed instead of served.
};

/// Simulates a scene no faster than time passes, and shows it in browsers, until a signal comes.
/// @throws Interrupted at the end; InputError as WebServer; DeviceError, RunError as Solver.
[[noreturn]] void serveScene(const LoadServed& load, const ServeOptions& options, const CommonOptions& common);

/// Simulates the changes of ServeOptions::replay, without a server. @returns the exit code: EXIT_DIFFERENT if another
/// state comes out. @throws as serveScene().
int replayChanges(const LoadServed& load, const ServeOptions& options, const CommonOptions& common);

}  // namespace knuckle
