#pragma once

#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// How strands of a world stand in the solver's buffers.
struct StrandOrder {
    std::vector<uint32_t> colors;   ///< Per strand: no two of a colour share a particle that moves.
    std::vector<uint32_t> strands;  ///< In the order of the buffers: by colours, the long ones of each first.
    std::vector<uint32_t> starts;   ///< Per strand, its first node; its last if it is reversed.
    std::vector<bool> reversed;     ///< Per strand: elimination begins at its end, which should be free.
    uint32_t nodeCount = 0;         ///< Of all strands.

    /// Index into "distanceStates" of a distance of a strand.
    size_t stateOf(const World& world, size_t strand, size_t distance) const;
};

StrandOrder strandOrder(const World& world);

/// Whether any distance may break or be let go.
bool canTear(const World& world);

}  // namespace knuckle
