#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/gpu/driver_threads.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/solver.h"
#include "sim/world/world.h"

namespace knuckle {

/// What the drawing of a film took.
struct DrawingFigures {
    uint64_t frames = 0;
    double seconds = 0.0;                                            ///< By the clock, on the thread that draws.
    std::vector<std::pair<std::string, KernelTimer::Total>> passes;  ///< Where they are timed.
};

/// What `--stats` tells beside what the solver knows.
struct RunFigures {
    std::string device;
    DriverThreads driverThreads;
    uint64_t frames = 0, steps = 0;
    double simulationSeconds = 0.0, totalSeconds = 0.0;
    DrawingFigures drawing;
    std::vector<ReleaseFigures> releases;
};

/// The text of `--stats`: JSON.
std::string statsText(const RunFigures& figures, const World& world, Solver& solver);

/// A state hash as it is printed everywhere: 16 hexadecimal digits.
std::string hashText(uint64_t hash);

}  // namespace knuckle
