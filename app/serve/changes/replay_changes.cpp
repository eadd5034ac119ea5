#include <fmt/format.h>

#include "app/run/counted.h"
#include "app/run/exit_codes.h"
#include "app/run/interrupt.h"
#include "app/run/tell.h"
#include "app/serve/changes/change_log.h"
#include "app/serve/changes/live_world.h"
#include "app/serve/live_run.h"
#include "sim/base/fnv_hash.h"
#include "sim/solver/workload.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

namespace {

void apply(LiveWorld& live, const LoggedChanges::Entry& entry, const std::string& log)
{
    try {
        live.apply(entry.change);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: step {}: {}", log, entry.step, error.what()));
    }
}

/// The state's hash after all changes.
std::string replay(const LoggedChanges& logged, const ServedScene& served, const std::string& log,
                   const CommonOptions& common)
{
    const Scene& scene = served.scene;
    const auto gpu = openGpu(common, FrameWork{stepWorkload(scene.world), {}});
    LiveWorld live(*gpu, scene, served.branch.get());
    const InterruptGuard guard;
    auto next = logged.changes.begin();
    for (uint64_t step = 0; step <= logged.steps; ++step) {
        guard.check();
        // As when they were made: no step before a change is taken again.
        live.check();
        for (; next != logged.changes.end() && next->step == step; ++next) apply(live, *next, log);
        if (step < logged.steps) live.step();
    }
    return hashText(live.solver().stateHash());
}

}  // namespace

int replayChanges(const LoadServed& load, const ServeOptions& options, const CommonOptions& common)
{
    const LoggedChanges logged = readChanges(options.replay);
    const auto served = load(logged.sets);
    if (logged.world != hashText(fingerprint(served->scene.world)))
        throw InputError(fmt::format("{}: is of another world, of the scene {}; give the same scene and --set",
                                     options.replay, logged.scene));
    const std::string hash = replay(logged, *served, options.replay, common);
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
