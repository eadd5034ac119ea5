#pragma once

#include <cstdint>

#include "app/states/states_file.h"
#include "sim/world/match/counterparts.h"

namespace knuckle {

/// What becomes of fluids in another world, in particles.
struct BranchedFluid {
    uint64_t kept = 0;   ///< Go on as they were.
    uint64_t lost = 0;   ///< Were there and are not any more.
    uint64_t added = 0;  ///< Begin where the other world has them.
    /// Whether some of what both worlds begin with has drained away, and the other world has no pool to hold it.
    bool drainedForGood = false;
};

/// Of a frame of a file of states. @param state the whole state of that frame, or of the last before it.
/// @throws InputError if the file is damaged.
BranchedFluid branchedFluid(const StatesFile& states, uint64_t frame, const RunState& state, const World& before,
                            const World& after, const Counterparts& same);

}  // namespace knuckle
