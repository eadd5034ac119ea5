// Releases that wait for something to happen to a body. What watches for it has a thread for each release and body, and
// runs at the end of a substep; mover_release lets go at the start of the next one.
#include "shared/release_types.h"
#include "sim/common/bodies/assemblies.glsl"

uniform usamplerBuffer releaseWatches;   // release, body
uniform usamplerBuffer releaseEntries;   // which of bodyReleases each release lets go
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

ReleaseWatch fetchReleaseWatch(uint index)
{
    uvec2 t = texelFetch(releaseWatches, int(index)).xy;
    return ReleaseWatch(t.x, t.y);
}

/// Lets go of a release's bodies in the next substep, where they still are held or animated.
void letGo(Release release)
{
    // The least counts, whoever says it first.
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

/// The same of what something touches: it begins by first order, as what is touched does.
void letGoTouched(Release release, uint assembly)
{
    letGo(release);
    assemblies[assembly].lastContact = counters[0].substep - 1u;
}
