// One thread a contact with a collider, touching or about to: a moving collider keeps what is beside it from being
// calm. WAKE: in a substep, it wakes the island of a sleeping mover.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/collider_moves.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer colliderSides;
#ifdef WAKE
BUFFER(uint, IslandsWoken, islandsWoken);
#else
BUFFER(Calm, AssemblyNext, assemblyNext);
#endif
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    ColliderContact sides = fetchColliderContact(colliderSides, q);
    if (fetchColliderMove(sides.collider).farthest == 0.0 || !mayRest(sides.mover)) return;
    uint assembly = fetchMover(sides.mover).assembly;
#ifdef WAKE
    Calm calm = fetchCalm(assembly);
    if (sleeps(calm)) islandsWoken[calm.island] = 1u;
#else
    assemblyNext[assembly].steps = 0u;
#endif
}
