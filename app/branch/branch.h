#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/branch/branched_fluid.h"
#include "app/scene/scene_file.h"
#include "app/states/run_fingerprint.h"
#include "app/states/run_state.h"
#include "sim/world/match/counterparts.h"

namespace knuckle {

/// Where a scene goes on from: a frame of another run, whose states a file has (`start` of the scene).
struct Branch {
    std::string file;
    RunFingerprint fingerprint;    ///< Of that run.
    uint64_t frame = 1;            ///< The first of the scene.
    RunState state;                ///< The last whole one up to there.
    uint32_t stepsPerFrame = 1;    ///< Of that run.
    std::unique_ptr<World> other;  ///< The world of that run; null if it is that of the scene.
    Counterparts same;             ///< If it is another.
    World begin;                   ///< Then the scene's world, with clips at the time of the frame.
    BranchedFluid fluid;           ///< Then, too.
    bool keepsCamera = false;      ///< Whether both have the same camera, so that it goes on as well.

    /// One sentence: what goes on as it was, what is new, what is gone.
    std::string note() const;
    /// The scene's world, as its solver begins with it.
    const World& world(const Scene& scene) const { return other ? begin : scene.world; }
};

/// Opens the states that a scene goes on from. Needs no GPU. @returns null if the scene begins at time 0.
/// @throws InputError, one line, for a file that cannot be read, a frame that is not there, and what does not fit.
std::unique_ptr<Branch> openBranch(const Scene& scene);

}  // namespace knuckle
