#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// The hash of all places and velocities, on the device; see shaders/shared/state_hash.h.
class StateHashStage : public Stage {
public:
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Not part of a step. Reads 8 bytes back.
    uint64_t hash(KernelTimer& timer);

private:
    uint32_t threads_ = 0;
    Buffer<uint32_t> stateHash{"stateHash", 2};
    Pass hash_{*this, "particle/state_hash"};
};

}  // namespace knuckle
