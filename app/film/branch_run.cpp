#include "app/film/branch_run.h"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Loads the whole state before the branch, and simulates up to its frame. @param seen gets each frame before it.
void reach(const Branch& branch, Solver& solver, const std::function<void(uint64_t)>& seen)
{
    try {
        solver.loadState(branch.state.solver);
    } catch (const std::logic_error& error) {
        throw InputError(fmt::format("{}: cannot be gone on from: {}; record it again with this version", branch.file,
                                     error.what()));
    }
    for (uint64_t frame = branch.state.frame + 1; frame <= branch.frame; ++frame) {
        for (uint32_t i = 0; i < branch.stepsPerFrame; ++i) solver.step();
        solver.checkCounters(frame);
        if (frame < branch.frame) seen(frame);
    }
}

}  // namespace

void beginBranch(const Branch& branch, Gpu& gpu, const Scene& scene, Solver& solver, FrameDrawing* drawing)
{
    const bool keepsCamera = drawing != nullptr && branch.keepsCamera && !branch.state.cameras.empty();
    if (keepsCamera) drawing->loadState(branch.state.cameras);
    if (!branch.other) {
        reach(branch, solver, [&](uint64_t frame) {
            if (!keepsCamera) return;
            const double time = scene.timeOf(frame);
            drawing->take(solver.view(), {.number = frame, .time = time, .drawn = false});
            drawing->fetch();
        });
        return;
    }
    Solver other(gpu, *branch.other);
    reach(branch, other, [](uint64_t) {});
    try {
        solver.carryOver(other, branch.same, (branch.frame - 1) * scene.stepsPerFrame);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: /start: {}", scene.file, error.what()));
    }
}

}  // namespace knuckle
