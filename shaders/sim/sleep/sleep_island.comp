// One thread a contact between particles: what touches is an island, as calm as the least calm of it and with one name.
#include "sim/common/kernel.glsl"
#include "sim/common/sleep.glsl"
#include "sim/common/one_sided.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairSides;        // movers
uniform samplerBuffer pairImpulses;
uniform usamplerBuffer moverInfo;
BUFFER(uvec2, AssemblyNext, assemblyNext);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uvec2 movers = texelFetch(pairSides, int(q)).xy & MOVER_MASK;
    uvec4 a = texelFetch(moverInfo, int(movers.x)), b = texelFetch(moverInfo, int(movers.y));
    bool touching = texelFetch(pairImpulses, int(counters[0].listParity * sim.pairCapacity + q)).w > 0.0;
    // Nothing passes through what is fixed.
    if (!touching || uintBitsToFloat(a.w) == 0.0 || uintBitsToFloat(b.w) == 0.0) return;
    uvec2 calmA = texelFetch(assemblyCalm, int(a.z)).xy, calmB = texelFetch(assemblyCalm, int(b.z)).xy;
    atomicMin(assemblyNext[a.z].x, calmB.x + 1u);
    atomicMin(assemblyNext[b.z].x, calmA.x + 1u);
    atomicMin(assemblyNext[a.z].y, calmB.y);
    atomicMin(assemblyNext[b.z].y, calmA.y);
}
