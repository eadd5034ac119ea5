#pragma once

#include <cstdint>
#include <string>

#include "app/golden/golden_file.h"
#include "sim/solver/measure/view_state.h"
#include "sim/world/world.h"

namespace knuckle {

/// How far a state is from a stored one.
struct StateDifference {
    bool sameBits = true;        ///< By their hashes; then there is nothing else to tell.
    bool sameParticles = false;  ///< Their bits are the same, though others differ.
    bool sameKind = true;        ///< As many particles, bodies and colliders; else only numbers of particles are known.
    uint64_t particles = 0, storedParticles = 0;
    uint64_t moved = 0;  ///< Particles further than the limit from where they were, or there in only one state.
    double mean = 0.0, largest = 0.0;  ///< Distances [diameters], of particles that are there in both.
    uint32_t farthest = 0;             ///< The particle with the largest distance.
    Vector3f place{0, 0, 0};           ///< Of that particle, now [m].
    uint64_t cameOrWent = 0;           ///< Particles that are there in only one of them.
    uint64_t torn = 0;                 ///< Particles of joints torn in only one of them.
    double colliders = 0.0;            ///< How far a collider is off at most [diameters].
    double turned = 0.0;               ///< By how much a collider is turned otherwise at most [radians].
    std::string most;  ///< What has most of the moved particles: an object, or a material of loose particles.
    uint64_t mostMoved = 0, mostCount = 0;  ///< Its moved particles, and all of them.
    std::string owner;                      ///< The same of the farthest particle.

    bool isWithin(const StateLimits& limits) const;
};

/// Whether colliders have the same bits.
bool sameColliders(const ViewState& stored, const ViewState& now);

/// @param stored as compact() leaves it, of which `world` may be another one now.
StateDifference compareStates(const World& world, const ViewState& stored, const ViewState& now,
                              const StateLimits& limits);

/// What differs, in words: "812 of 1557 particles are more than 0.1 diameters from where they were, ...".
std::string differenceWords(const StateDifference& difference, const StateLimits& limits);

}  // namespace knuckle
