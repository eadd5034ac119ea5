#include <algorithm>

#include "shared/foam_ring.h"
#include "sim/solver/carry/carrying.h"

namespace knuckle {

/// In a ring of the same size every point keeps its slot, and so its bits; else the latest come first in the new one.
void carryFoam(const Carrying& c)
{
    if (!c.has("foamRing")) return;
    const auto places = readState<gpu::vec4>(c.from, "foamPlaces"), moves = readState<gpu::vec4>(c.from, "foamMoves");
    auto newPlaces = readState<gpu::vec4>(c.to, "foamPlaces"), newMoves = readState<gpu::vec4>(c.to, "foamMoves");
    auto ring = readState<gpu::uvec4>(c.from, "foamRing");
    gpu::uvec4& state = ring.at(FOAM_RING);
    if (places.size() == newPlaces.size()) {
        newPlaces = places;
        newMoves = moves;
    } else {
        const auto room = static_cast<uint32_t>(newPlaces.size()), size = static_cast<uint32_t>(places.size());
        const uint32_t kept = std::min(state.y, room);
        for (uint32_t k = 0; k < kept; ++k) {
            const uint32_t slot = (state.x + size - kept + k) % size;
            newPlaces[k] = places[slot];
            newMoves[k] = moves[slot];
        }
        state = {kept % room, kept, 0, 1};
    }
    writeState(c.to, "foamPlaces", newPlaces);
    writeState(c.to, "foamMoves", newMoves);
    writeState(c.to, "foamRing", ring);
}

}  // namespace knuckle
