#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shared/motor_types.h"
#include "sim/gpu/gpu.h"
#include "sim/solver/edit/state_edit.h"
#include "sim/solver/list_room.h"
#include "sim/solver/measure/contact_force.h"
#include "sim/solver/measure/releases.h"
#include "sim/solver/measure/state.h"
#include "sim/solver/measure/view_state.h"
#include "sim/solver/particle_view.h"
#include "sim/solver/stages_state.h"
#include "sim/world/forces/surroundings.h"
#include "sim/world/match/counterparts.h"
#include "sim/world/world.h"

namespace knuckle {

struct PassTime {
    std::string name;           ///< The kernel's: `contact_find`, ...
    double milliseconds = 0.0;  ///< Total since the solver was made.
    uint64_t count = 0;         ///< Dispatches.
};

/// All that a run carries from one step to the next. With the same World, program and driver, a run that loads it
/// continues with the same bits.
struct SolverState {
    bool started = false;
    StagesState stages;
    std::vector<gpu::Motor> motors = {};  ///< What drives joints.
};

/// When a solver's kernels are compiled.
enum class Loading {
    Now,
    AtFirstStep  ///< For a run that may show nothing but the start.
};

/// A World on the GPU, and its step.
class Solver {
public:
    /// Uploads the world once. @throws DeviceError, with the number, when the device's limits are too small for it.
    /// @param world must outlive it. @param room first capacities of lists, for tests: bits do not depend on them.
    Solver(Gpu& gpu, const World& world, const std::optional<ListRoom>& room = {}, Loading loading = Loading::Now);
    Solver(Gpu& gpu, World&& world, const std::optional<ListRoom>& room = {}, Loading loading = Loading::Now) = delete;
    ~Solver();
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// Compiles what a step needs, unless that is done; else the first step does. @throws DeviceError.
    void prepare();
    /// Advances by Settings::timeStep. Only records GL work: nothing is uploaded, nothing read back.
    void step();
    /// Once a frame: reads the counters, 72 bytes. Steps in which lists overflowed are repeated with more room.
    /// @throws RunError for NaN or an overflow that cannot be fixed, naming frame, particle and the number to raise.
    void checkCounters(uint64_t frame);

    ParticleView view() const;
    // Everything below stalls until the GPU is done.
    ViewState readView();
    ParticleState readParticles();
    std::vector<BodyState> readBodies();
    /// The world's colliders at their current places.
    std::vector<Collider> readColliders();
    Measures measure();
    /// Of each fluid particle, in order: its density in the last step over that at rest; 1 before the first, and of
    /// one that is inactive or has only just come.
    std::vector<float> fluidDensities();
    /// Of the bits of all positions and velocities, see shaders/shared/state_hash.h; reads 8 bytes.
    uint64_t stateHash();
    SolverState saveState() const;
    /// @throws std::logic_error if it is not from a solver of the same World.
    void loadState(const SolverState& state);
    /// Before the first step: takes over from a solver of another world what both have, as it is there, after as many
    /// steps of this world. All else stays where this world has it; what sleeps wakes, releases that are over happen
    /// at once. @throws std::logic_error for fluid that has drained away where this world has neither drains nor
    /// emitters.
    void carryOver(const Solver& other, const Counterparts& same, uint64_t steps);
    // The next three come after checkCounters(): no step before them is taken again.
    /// Changes the state before the next step. Reads and writes all of it.
    void edit(const std::function<void(StateEdit&)>& change);
    /// Gravity, wind and damping from the next step on; what sleeps wakes. Reads and writes the whole state.
    void surround(const Surroundings& surroundings);
    /// Changes what drives a joint. @returns false if nothing drives it.
    bool drive(uint32_t joint, const TurnDrive& drive);
    /// Contacts that act. @throws std::logic_error with the paper's solver, which has no impulses.
    std::vector<ContactForce> contactForces();
    /// Number of searches for contacts, at most one a substep.
    uint32_t searchCount();
    /// Of all buffers that kernels know by name [bytes].
    uint64_t bufferBytes();
    std::vector<PassTime> passTimes();
    /// Times every pass from now on, for passTimes().
    void timePasses();
    /// Notes how bodies that are let go move on, for letGo(); call it before the first step.
    void noteReleases();
    /// All bodies that were let go so far. Stalls until the GPU is done.
    std::vector<LetGo> letGo();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
