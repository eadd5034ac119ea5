// One thread: sets the sizes of the dispatches that let collisions bounce, to zero if nothing collides in the substep.
#include "sim/common/kernel.glsl"
#include "shared/contact_constants.h"
#include "sim/common/groups.glsl"

layout(local_size_x = 1) in;
READ_BUFFER(uint, LastCollision, lastCollision);
READ_BUFFER(Counters, CountersBlock, counters);
READ_BUFFER(uvec4, Dispatches, dispatches);
BUFFER(uvec4, RestitutionSizes, restitutionSizes);

void main()
{
    uint on = lastCollision[0] == counters[0].substep ? 1u : 0u;
    restitutionSizes[RESTITUTION_PAIRS_SIZE] = uvec4(on * dispatches[DISPATCH_PAIRS].x, 1, 1, 0);
    restitutionSizes[RESTITUTION_COLLIDER_PAIRS_SIZE] = uvec4(on * dispatches[DISPATCH_COLLIDER_PAIRS].x, 1, 1, 0);
    restitutionSizes[RESTITUTION_MOVERS_SIZE] = uvec4(on * groups(sim.moverCount), 1, 1, 0);
}
