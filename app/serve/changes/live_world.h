#pragma once

#include <cstdint>

#include "app/branch/branch.h"
#include "app/scene/scene_file.h"
#include "app/serve/changes/change.h"
#include "app/serve/changes/live_fields.h"

namespace knuckle {

/// A scene that is simulated while it is changed: the same changes before the same steps give the same bits.
class LiveWorld {
public:
    /// @param branch what it goes on from; null: it begins at its start. @throws as Solver.
    LiveWorld(Gpu& gpu, const Scene& scene, const Branch* branch);

    Solver& solver() { return solver_; }
    const World& world() const { return scene_.world; }
    const std::vector<LiveField>& fields() const { return fields_.all(); }
    /// Since the start.
    uint64_t steps() const { return steps_; }
    /// Since the start [s].
    double time() const { return static_cast<double>(steps_) * static_cast<double>(world().settings.timeStep); }

    void step();
    /// After steps: no step before a change is taken again.
    void check() { solver_.checkCounters(steps_); }
    /// Before the next step, after check(). @throws InputError, and changes nothing, for what cannot be done.
    void apply(const Change& change);

private:
    const Scene& scene_;
    Solver solver_;
    SolverState begin_;
    LiveFields fields_;
    uint64_t steps_ = 0;
};

}  // namespace knuckle
