#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/gpu/device/driver_threads.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/solver.h"
#include "sim/world/world.h"

namespace knuckle {

/// Costs of drawing a film.
struct DrawingFigures {
    uint64_t frames = 0;
    double seconds = 0.0;                                            ///< Wall-clock time on the thread that draws.
    double firstSeconds = 0.0;                                       ///< Of that, up to the first frame.
    std::vector<std::pair<std::string, KernelTimer::Total>> passes;  ///< If they are timed.
};

/// Figures of `--stats` other than the solver's.
struct RunFigures {
    std::string device;
    DriverThreads driverThreads;
    uint64_t frames = 0, steps = 0;
    double simulationSeconds = 0.0, totalSeconds = 0.0;
    /// Parts of the start [s]: the device is opened, the world uploaded, what a step needs compiled.
    struct {
        double device = 0.0, world = 0.0, kernels = 0.0;
    } start = {};
    /// The same until all shaders were compiled.
    struct {
        double totalSeconds = 0.0, simulationSeconds = 0.0;
    } warm = {};
    DrawingFigures drawing;
    std::vector<ReleaseFigures> releases;
};

/// The text of `--stats`: JSON.
std::string statsText(const RunFigures& figures, const World& world, Solver& solver);

}  // namespace knuckle
