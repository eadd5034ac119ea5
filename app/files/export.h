#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/files/output_file.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/solver.h"
#include "sim/world/world.h"

namespace knuckle {

/// Writes frame_0001.ply: binary PLY with id, position [m], velocity [m/s], body (-1: none) and material (index; its
/// comments have their names), of all particles but the fluid ones that are in pools of emitters or went into drains:
/// ids may have gaps.
/// @throws RunError from a full disk.
void writePly(const std::string& folder, uint64_t frame, const World& world, const ParticleState& state);

/// One CSV file for all frames: frame, body, object, name, position [m], quaternion (xyzw), velocity [m/s], angular
/// velocity [rad/s].
class BodyTable {
public:
    /// @throws InputError when the file cannot be written.
    explicit BodyTable(const std::string& path);
    void write(uint64_t frame, const World& world, const std::vector<BodyState>& states);
    void finish() { file_.commit(); }

private:
    OutputFile file_;
};

/// One CSV file for all frames: the Measures of each, as `--stats` names them.
class MeasureTable {
public:
    /// @throws InputError when the file cannot be written.
    explicit MeasureTable(const std::string& path);
    void write(uint64_t frame, const Measures& measures);
    void finish() { file_.commit(); }

private:
    OutputFile file_;
};

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
