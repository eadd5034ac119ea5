#pragma once

#include <cstdint>

namespace knuckle {

/// How much room the lists of contacts and of fluids' neighbours have. They grow where that is too little.
struct ListRoom {
    uint32_t candidates = 0;  ///< Contacts of all kinds that a search finds, >= 1.
    uint32_t pairs = 0;       ///< Of particles, and of particles and colliders, >= 1 of each.
    uint32_t neighbours = 0;  ///< That one particle can have in fluids, a multiple of 4, >= 4.
};

}  // namespace knuckle
