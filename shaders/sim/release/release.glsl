// Releases that wait for something to happen to a body. Kernels that watch for it have a thread for each release and
// body, and run at the end of a substep; mover_release lets go at the start of the next one.
#include "shared/release_types.h"
#include "sim/common/bodies/assemblies.glsl"

uniform usamplerBuffer releaseWatches;   // release, body
uniform usamplerBuffer releaseEntries;   // entries of bodyReleases that each release lets go
READ_BUFFER(Release, Releases, releases);
BUFFER(uvec2, BodyReleases, bodyReleases);
#ifdef PUPPETS
uniform usamplerBuffer releaseLimps;     // animated bodies
BUFFER(uvec4, LimpSubsteps, limpSubsteps);
#endif
BUFFER(Assembly, AssemblyState, assemblies);
READ_BUFFER(Counters, CountersBlock, counters);

struct ReleaseWatch {
    uint release, body;
};

/// Whether a mover belongs to another object than the body that a release watches.
bool isAnother(Release release, uint mover)
{
    return mover < release.firstBody || mover >= release.bodyEnd;
}

ReleaseWatch fetchReleaseWatch(uint index)
{
    uvec2 t = texelFetch(releaseWatches, int(index)).xy;
    return ReleaseWatch(t.x, t.y);
}

/// Lets go of a release's bodies in the next substep, if they are still held or animated.
void letGo(Release release)
{
    // The least number counts, whichever thread writes first.
    for (uint k = release.firstEntry; k < release.entryEnd; ++k)
        atomicMin(bodyReleases[texelFetch(releaseEntries, int(k)).x].y, counters[0].substep);
#ifdef PUPPETS
    for (uint k = release.firstLimp; k < release.limpEnd; ++k) {
        uint body = texelFetch(releaseLimps, int(k)).x;
        if (counters[0].substep < limpSubsteps[body].z) atomicMin(limpSubsteps[body].x, counters[0].substep);
        else atomicMin(limpSubsteps[body].y, counters[0].substep);
    }
#endif
}

/// The same for a body that something touches: it starts with first order, like other touched bodies.
void letGoTouched(Release release, uint assembly)
{
    letGo(release);
    assemblies[assembly].lastContact = counters[0].substep - 1u;
}
