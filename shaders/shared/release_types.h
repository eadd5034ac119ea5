// Structs of releases that C++ and GLSL share; as in gpu_types.h, of four-byte scalars and sixteen-byte vectors.
#ifndef KNUCKLE_RELEASE_TYPES_H
#define KNUCKLE_RELEASE_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Lets go of bodies when something happens to one of them.
struct Release {
    uint firstEntry;                // of the bodies that it lets go, in releaseEntries
    uint entryEnd;
    uint firstBody;                 // of their object, whose bodies do not trigger each other
    uint bodyEnd;
    uint firstParticle;             // whose touch lets go
    uint particleEnd;
    float impulse;                  // of contacts in a step [N s]
    uint region;                    // among the colliders
    uint firstLimp;                 // of those that go limp with it, in releaseLimps
    uint limpEnd;
    uint unused1;
    uint unused2;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
