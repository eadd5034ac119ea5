// Structs of releases that C++ and GLSL share; as in gpu_types.h, of scalars of four bytes and vectors of sixteen.
#ifndef KNUCKLE_RELEASE_TYPES_H
#define KNUCKLE_RELEASE_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// What lets go of bodies when something happens to one of them.
struct Release {
    uint firstEntry;                // of those that it lets go, in releaseEntries
    uint entryEnd;
    uint firstBody;                 // of their object, whose bodies do nothing to each other
    uint bodyEnd;
    uint firstParticle;             // that touch them
    uint particleEnd;
    float impulse;                  // of contacts in a step [N s]
    uint region;                    // among the colliders
    uint firstLimp;                 // of what goes limp by it, in releaseLimps
    uint limpEnd;
    uint unused1;
    uint unused2;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
