#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/gpu/gpu.h"
#include "sim/solver/list_room.h"
#include "sim/solver/measure/releases.h"
#include "sim/solver/measure/state.h"
#include "sim/solver/particle_view.h"
#include "sim/solver/stages_state.h"
#include "sim/world/world.h"

namespace knuckle {

struct PassTime {
    std::string name;           ///< The kernel's: `contact_find`, ...
    double milliseconds = 0.0;  ///< Total since the solver was made.
    uint64_t count = 0;         ///< Dispatches.
};

/// All that a run carries from one step to the next. Of the same World, program and driver, it goes on with the same
/// bits.
struct SolverState {
    bool started = false;
    StagesState stages;
};

/// A World on the GPU, and its step.
class Solver {
public:
    /// Uploads the world once. @throws DeviceError when the device's limits are too small for it, with the number.
    /// @param world must outlive it. @param room that lists begin with, for tests: bits do not depend on it.
    Solver(Gpu& gpu, const World& world, const std::optional<ListRoom>& room = {});
    Solver(Gpu& gpu, World&& world, const std::optional<ListRoom>& room = {}) = delete;
    ~Solver();
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// Advances by Settings::timeStep. Only records GL work: nothing is uploaded, nothing read back.
    void step();
    /// Once a frame: reads the 68-byte counters buffer. Steps in which lists overflowed are taken again, with more
    /// room.
    /// @throws RunError for NaN or an overflow that cannot be mended, naming frame, particle and the number to raise.
    void checkCounters(uint64_t frame);

    ParticleView view() const;
    // Everything below stalls until the GPU is done.
    ParticleState readParticles();
    std::vector<BodyState> readBodies();
    /// The world's, where they are now.
    std::vector<Collider> readColliders();
    Measures measure();
    /// FNV-1a over the bits of all positions and velocities.
    uint64_t stateHash();
    SolverState saveState() const;
    /// @throws std::logic_error where it is not of a solver of the same World.
    void loadState(const SolverState& state);
    /// How often contacts have been looked for, at most once a substep.
    uint32_t searchCount();
    std::vector<PassTime> passTimes();
    /// From now on times every pass, for passTimes().
    void timePasses();
    /// Notes how what is let go moves on, for letGo(); to be called before the first step.
    void noteReleases();
    /// All bodies that were let go so far. Stalls until the GPU is done.
    std::vector<LetGo> letGo();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
