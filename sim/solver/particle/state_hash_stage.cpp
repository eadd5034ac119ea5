#include "sim/solver/particle/state_hash_stage.h"

#include "shared/state_hash.h"
#include "sim/solver/measure/view_state.h"

namespace knuckle {

void StateHashStage::upload(const StageSetup& setup)
{
    const auto particles = static_cast<uint32_t>(setup.world.particles.size());
    threads_ = (particles + HASHED_PARTICLES - 1) / HASHED_PARTICLES;
}

void StateHashStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Scratch, stateHash);
}

uint64_t StateHashStage::hash(KernelTimer& timer)
{
    stateHash.clear();
    if (threads_ > 0) hash_.dispatch(timer, groupsFor(threads_));
    const std::vector<uint32_t> sums = stateHash.download();
    return joinedHash(sums[0], sums[1]);
}

}  // namespace knuckle
