#include "sim/solver/rope/strand_step.h"

namespace knuckle {

StrandStep::StrandStep(const Gpu& gpu, SolverBuffers& buffers) : phases_(buffers.strandPhases)
{
    if (phases_.empty()) return;
    const BufferTable table = buffers.table();
    const auto load = [&](const Defines& defines) { return Kernel(gpu, table, "sim/rope/strand_solve.comp", defines); };
    first_ = load({{"FIRST", "1"}});
    later_ = load({});
    firstWithBodies_ = load({{"FIRST", "1"}, {"BODIES", "1"}});
    laterWithBodies_ = load({{"BODIES", "1"}});
}

void StrandStep::run(KernelTimer& timer, bool first) const
{
    for (const StrandPhase& phase : phases_) {
        const Kernel& kernel = phase.hasBodies ? (first ? firstWithBodies_ : laterWithBodies_)
                                               : (first ? first_ : later_);
        glProgramUniform2ui(kernel.program(), 0, phase.begin, phase.end);
        kernel.dispatch(timer, (phase.end - phase.begin + STRAND_GROUP_SIZE - 1) / STRAND_GROUP_SIZE);
    }
}

}  // namespace knuckle
