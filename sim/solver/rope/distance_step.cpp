#include "sim/solver/rope/distance_step.h"

namespace knuckle {

DistanceStep::DistanceStep(const Gpu& gpu, SolverBuffers& buffers) : phases_(buffers.distanceColors)
{
    if (phases_.empty()) return;
    const BufferTable table = buffers.table();
    const auto load = [&](const Defines& defines) { return Kernel(gpu, table, "sim/rope/distance_solve.comp", defines); };
    first_ = load({{"FIRST_ITERATION", "1"}});
    later_ = load({});
    firstWithBodies_ = load({{"FIRST_ITERATION", "1"}, {"BODIES", "1"}});
    laterWithBodies_ = load({{"BODIES", "1"}});
}

void DistanceStep::run(KernelTimer& timer, bool first) const
{
    for (const DistanceColor& phase : phases_) {
        const Kernel& kernel = phase.hasBodies ? (first ? firstWithBodies_ : laterWithBodies_)
                                               : (first ? first_ : later_);
        glProgramUniform2ui(kernel.program(), 0, phase.begin, phase.end);
        kernel.dispatch(timer, (phase.end - phase.begin + DISTANCE_GROUP_SIZE - 1) / DISTANCE_GROUP_SIZE);
    }
}

}  // namespace knuckle
