#include <fmt/format.h>

#include "app/film/branch_run.h"
#include "app/run/counted.h"
#include "app/run/exit_codes.h"
#include "app/run/interrupt.h"
#include "app/run/tell.h"
#include "app/serve/change_log.h"
#include "app/serve/live_run.h"
#include "sim/base/fnv_hash.h"
#include "sim/solver/workload.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

int replayChanges(const Scene& scene, const Branch* branch, const ServeOptions& options, const CommonOptions& common)
{
    const LoggedChanges logged = readChanges(options.replay, fingerprint(scene.world));
    const auto gpu = openGpu(common, FrameWork{stepWorkload(scene.world), {}});
    Solver solver(*gpu, branch != nullptr ? branch->world(scene) : scene.world);
    if (branch != nullptr) beginBranch(*branch, *gpu, scene, solver, nullptr);
    const InterruptGuard guard;
    auto next = logged.changes.begin();
    for (uint64_t step = 0; step <= logged.steps; ++step) {
        guard.check();
        // As when they were made: no step before a change is taken again.
        solver.checkCounters(step);
        for (; next != logged.changes.end() && next->step == step; ++next)
            applyChange(solver, scene.world, next->change);
        if (step < logged.steps) solver.step();
    }
    const std::string hash = hashText(solver.stateHash());
    if (!common.quiet)
        fmt::print("{} and {} of {}\n", counted(logged.steps, "step"), counted(logged.changes.size(), "change"),
                   options.replay);
    if (options.hash) fmt::print("state hash {}\n", hash);
    if (logged.hash.empty()) {
        tellUser(
            fmt::format("knuckle: {}: its end is not recorded; this is the state after its last change, at step {}",
                        options.replay, logged.steps));
        return EXIT_FINE;
    }
    if (hash == logged.hash) return EXIT_FINE;
    tellUser(fmt::format("knuckle: {}: the state is {} at the end, and was {}; drivers or versions differ",
                         options.replay, hash, logged.hash));
    return EXIT_DIFFERENT;
}

}  // namespace knuckle
