#include "app/branch/branched_fluid.h"

#include <algorithm>
#include <vector>

#include "app/states/view_coding.h"
#include "sim/solver/emitter/emitter_stage.h"
#include "sim/solver/state_values.h"

namespace knuckle {

namespace {

/// Per particle, whether it is there: not drained away, and not waiting in the pool of an emitter.
std::vector<bool> activeParticles(const StatesFile& states, uint64_t frame, const RunState& state, const World& world)
{
    std::vector<gpu::vec4> positions;
    if (std::ranges::binary_search(states.frames(), frame))
        positions = ViewCoding(world).unpack(states.blocks(), frame).positions;
    else positions = readState<gpu::vec4>(state.solver.stages, "positions");
    std::vector<bool> active;
    for (const gpu::vec4& position : positions) active.push_back(position.w == 0.0f);
    return active;
}

}  // namespace

BranchedFluid branchedFluid(const StatesFile& states, uint64_t frame, const RunState& state, const World& before,
                            const World& after, const Counterparts& same)
{
    BranchedFluid fluid;
    if (before.fluidCount == 0 && after.fluidCount == 0) return fluid;
    const std::vector<bool> active = activeParticles(states, frame, state, before);
    const bool hasPools = EmitterStage::isNeeded(after);
    const size_t filledEnd = after.particles.size() - after.pooledCount();
    for (uint32_t p = before.solidCount(); p < before.particles.size(); ++p) fluid.lost += active.at(p) ? 1 : 0;
    for (uint32_t p = after.solidCount(); p < after.particles.size(); ++p) {
        const uint32_t was = same.particles[p];
        const bool isFilled = p < filledEnd;
        if (was == NO_INDEX) {
            fluid.added += isFilled ? 1 : 0;
        } else if (active.at(was)) {
            ++fluid.kept;
            --fluid.lost;
        } else if (isFilled && !hasPools) {
            fluid.drainedForGood = true;
        }
    }
    return fluid;
}

}  // namespace knuckle
