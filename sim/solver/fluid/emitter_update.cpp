#include "sim/solver/fluid/emitter_update.h"

namespace knuckle {

FluidPool::FluidPool(const LoadKernel& load, SolverBuffers& buffers)
    : sizes_(buffers.dispatches), hasEmitters_(buffers.parameters.poolCapacity > 0),
      chunks_(groupsFor(buffers.parameters.poolCapacity / SCAN_CHUNK)),
      fluids_(groupsFor(buffers.parameters.fluidFilled + buffers.parameters.poolCapacity))
{
    sum_ = load("search/scan_sum", {{"POOLS", "1"}});
    sumChunks_ = load("search/scan_chunks", {{"POOLS", "1"}});
    pool_ = load("fluid/emitter_update", {});
    order_ = load("fluid/pool_order", {});
    emit_ = load("fluid/fluid_emit", {{"FLUIDS", "1"}});
    drain_ = load("fluid/fluid_drain", {});
}

void FluidPool::run(KernelTimer& timer) const
{
    if (hasEmitters_) {
        sum_.dispatch(timer, chunks_);
        sumChunks_.dispatch(timer, 1);
    }
    pool_.dispatch(timer, 1);
    if (hasEmitters_) {
        order_.dispatch(timer, chunks_);
        emit_.dispatchIndirect(timer, sizes_, DISPATCH_EMIT);
    }
    drain_.dispatch(timer, fluids_);
}

}  // namespace knuckle
