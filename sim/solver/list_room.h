#pragma once

#include <cstdint>

namespace knuckle {

/// Capacities of the lists of contacts and of fluids' neighbours. They grow when they are too small.
struct ListRoom {
    uint32_t candidates = 0;  ///< Contacts of all kinds that a search may find, >= 1.
    uint32_t pairs = 0;       ///< Of particles, and of particles and colliders, >= 1 of each.
    uint32_t neighbours = 0;  ///< Of one particle in fluids, a multiple of 4, >= 4.
};

}  // namespace knuckle
