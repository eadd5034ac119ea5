// What kernels count, and the problems that they report. Members as in step_parameters.h.
#ifndef KNUCKLE_COUNTERS_H
#define KNUCKLE_COUNTERS_H

#include "shared/gpu_types.h"

// Bits of Counters::problems.
#define PROBLEM_CANDIDATES 1u
#define PROBLEM_NAN 2u
#define PROBLEM_PAIRS 4u
#define PROBLEM_FLUID 8u
#define PROBLEM_FLUID_ENERGY 16u

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Written by kernels, read once a frame. 72 bytes.
struct Counters {
    // Problems: PROBLEM_*, one particle that has them, and the capacities that would have sufficed.
    uint problems;
    uint badParticle;               // one particle that turned NaN
    uint wantedCandidates;          // most contacts that a search would have found
    uint wantedPairs;
    uint wantedColliderPairs;
    uint wantedNeighbours;          // most that a particle would have had in fluids
    // Substeps and searches.
    uint substep;                   // substeps since the start
    uint due;                       // something has used up its margin
    uint searchCount;               // times the candidates were found
    uint listParity;                // which half of the candidate lists is current
    uint pairCount;                 // contacts between particles, touching or about to
    uint colliderPairCount;         // contacts with colliders
    uint fastCount;                 // particles of movers that will soon leave their margin
    uint fastListed;                // those of them that look further for contacts
    uint fastLater;                 // particles of movers that will leave it in FAR_SIGHT times as long
    uint candidateCount;            // contacts of all kinds found in this search
    uint freeMoved;                     // something is neither animated nor fixed; only set if anything is animated
    uint farSighted;                    // 1: the last search found few of these, so contacts are found for that long
};

#ifdef __cplusplus
static_assert(sizeof(Counters) == 72);
}  // namespace knuckle::gpu
#endif
#endif
