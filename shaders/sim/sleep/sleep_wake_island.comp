// One thread a contact between particles, touching or about to: what moves wakes the island of what sleeps.
#include "sim/common/kernel.glsl"
#include "sim/common/sleep.glsl"
#include "sim/common/one_sided.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairSides;        // movers
uniform usamplerBuffer moverInfo;
BUFFER(uint, IslandsWoken, islandsWoken);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uvec2 movers = texelFetch(pairSides, int(q)).xy & MOVER_MASK;
    uint a = texelFetch(moverInfo, int(movers.x)).z, b = texelFetch(moverInfo, int(movers.y)).z;
    uvec2 calmA = texelFetch(assemblyCalm, int(a)).xy, calmB = texelFetch(assemblyCalm, int(b)).xy;
    if (calmA.x >= sim.calmSteps && calmB.x == 0u) islandsWoken[calmA.y] = 1u;
    if (calmB.x >= sim.calmSteps && calmA.x == 0u) islandsWoken[calmB.y] = 1u;
}
