// One thread a body that is held or animated and may be let go: lets go of it in its substep, from rest or at its
// velocity. It wakes, and a search for contacts becomes due.
#define BODIES
#include "sim/common/kernel.glsl"
#include "shared/contact_constants.h"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/outside.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer bodyReleases;     // body, and the first substep in which it responds; NO_SUBSTEP: not yet known
uniform samplerBuffer moverVelocities;
#ifdef THROWS
uniform samplerBuffer bodyThrows;        // five a body: velocity field; xyz centre
BUFFER(vec4, MoverVelocities, newMoverVelocities);
BUFFER(vec4, MoverCentres, newMoverCentres);
#endif
BUFFER(uint, MoverStates, newMoverStates);
BUFFER(vec4, OldMoverVelocities, oldMoverVelocities);
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(Assembly, AssemblyState, assemblies);
#ifdef SLEEP
BUFFER(uvec2, AssemblyCalm, assemblyCalm);   // steps, island
#endif
BUFFER(Counters, CountersBlock, counters);

// A held body starts as it is thrown; one that was not there yet gets its place.
void throwHeld(uint k, uint body)
{
#ifdef THROWS
    int first = 5 * int(k);
    for (int i = 0; i < 4; ++i) newMoverVelocities[fieldStart(body) + uint(i)] = texelFetch(bodyThrows, first + i);
    newMoverCentres[body] = vec4(texelFetch(bodyThrows, first + 4).xyz, 0);
#endif
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.releaseCount) return;
    uvec2 release = texelFetch(bodyReleases, int(k)).xy;
    if (release.y != counters[0].substep) return;
    uint assembly = fetchMover(release.x).assembly;
    // A held body starts with first order; an animated one as if outside accelerations had led to its velocity.
    if (newMoverStates[release.x] == MOVER_FIXED) {
        assemblies[assembly].lastContact = counters[0].substep - 1u;
        throwHeld(k, release.x);
    } else oldMoverVelocities[fieldStart(release.x)].xyz = fetchField(moverVelocities, release.x).t -
                                                         sim.substepTime * outsideAcceleration(release.x);
    newMoverStates[release.x] = MOVER_DYNAMIC;
    moverMoves[release.x].w = JUST_LET_GO;
#ifdef SLEEP
    assemblyCalm[assembly] = uvec2(0u, assembly);
#endif
    counters[0].due = 1u;
}
