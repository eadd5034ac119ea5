// The hash of a state: of each particle the bits of its place and velocity, mixed; the sum over all particles, which
// does not depend on their order. Two such sums, of other seeds, are the 64 bits. The mix is "lowbias32" of Chris
// Wellons' hash prospector (bias 0.17).
#ifndef KNUCKLE_STATE_HASH_H
#define KNUCKLE_STATE_HASH_H

#define HASHED_PARTICLES 32u   // by one thread
#define STATE_HASH_LOW 0x9e3779b9u
#define STATE_HASH_HIGH 0x7f4a7c15u

#ifdef __cplusplus
#include "shared/vector_types.h"
namespace knuckle::gpu {
#define SHARED_FUNCTION inline
#else
#define SHARED_FUNCTION
#endif

// `hash` after one more word.
SHARED_FUNCTION uint mixedHash(uint hash, uint word)
{
    hash ^= word;
    hash ^= hash >> 16u;
    hash *= 0x7feb352du;
    hash ^= hash >> 15u;
    hash *= 0x846ca68bu;
    return hash ^ (hash >> 16u);
}

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
