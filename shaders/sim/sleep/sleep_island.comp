// One thread a contact between particles: touching assemblies are an island, as calm as the least calm, with one name.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairSides;
uniform samplerBuffer pairImpulses;
BUFFER(Calm, AssemblyNext, assemblyNext);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uvec2 movers = fetchContactSides(pairSides, q).movers;
    bool touching = fetchImpulse(pairImpulses, counters[0].listParity * sim.pairCapacity + q).normal > 0.0;
    // Held bodies connect no islands.
    if (!touching || !mayRest(movers.x) || !mayRest(movers.y)) return;
    uint a = fetchMover(movers.x).assembly, b = fetchMover(movers.y).assembly;
    Calm calmA = fetchCalm(a), calmB = fetchCalm(b);
    atomicMin(assemblyNext[a].steps, calmB.steps + 1u);
    atomicMin(assemblyNext[b].steps, calmA.steps + 1u);
    atomicMin(assemblyNext[a].island, calmB.island);
    atomicMin(assemblyNext[b].island, calmA.island);
}
