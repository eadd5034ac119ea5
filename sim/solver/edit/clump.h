#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Particles around a place that may be moved, and how much each counts: 1 in the middle, 0 at the edge.
struct Clump {
    std::vector<std::pair<uint32_t, float>> shares;
    float mass = 0.0f;  ///< By shares [kg].

    bool empty() const { return shares.empty(); }
};

/// Of loose particles first ... end - 1 nearer to a place than `radius` [m].
/// @param placeOf their places: an optional Vector3f of each, none for one that is not there.
template <typename PlaceOf>
Clump clumpAround(const World& world, uint32_t first, uint32_t end, const Vector3f& at, float radius, PlaceOf placeOf)
{
    Clump clump;
    for (uint32_t i = first; i < end; ++i) {
        if (world.particles[i].pinned) continue;
        const auto place = placeOf(i);
        if (!place) continue;
        const float share = 1.0f - (*place - at).squaredNorm() / (radius * radius);
        if (!(share > 0.0f)) continue;
        clump.shares.emplace_back(i, share);
        clump.mass += share * world.particles[i].mass;
    }
    return clump;
}

}  // namespace knuckle
