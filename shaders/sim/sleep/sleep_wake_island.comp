// One thread a contact between particles, touching or about to: a moving side wakes the island of a sleeping one.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairSides;
BUFFER(uint, IslandsWoken, islandsWoken);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uvec2 movers = fetchContactSides(pairSides, q).movers;
    Calm a = fetchCalm(fetchMover(movers.x).assembly), b = fetchCalm(fetchMover(movers.y).assembly);
    if (sleeps(a) && b.steps == 0u) islandsWoken[a.island] = 1u;
    if (sleeps(b) && a.steps == 0u) islandsWoken[b.island] = 1u;
}
