// One thread a body that is held or animated until a time: lets go of it then, from rest or as it moves. It wakes, and
// everything looks for contacts.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/mover_info.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer bodyReleases;     // body, and the substep that it responds in first
BUFFER(uint, MoverStates, newMoverStates);
BUFFER(Assembly, AssemblyState, assemblies);
#ifdef SLEEP
BUFFER(uvec2, AssemblyCalm, assemblyCalm);   // steps, island
#endif
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.releaseCount) return;
    uvec2 release = texelFetch(bodyReleases, int(k)).xy;
    if (release.y != counters[0].substep) return;
    uint assembly = fetchMover(release.x).assembly;
    // Of first order, where nothing led up to it.
    if (newMoverStates[release.x] == MOVER_FIXED) assemblies[assembly].lastContact = counters[0].substep - 1u;
    newMoverStates[release.x] = MOVER_DYNAMIC;
#ifdef SLEEP
    assemblyCalm[assembly] = uvec2(0u, assembly);
#endif
    counters[0].due = 1u;
}
