// The work group of stack_trees, which goes through all bodies in each round. For trees and for rings it has as many
// rounds as drivers let it run through (STACK_TURNS); what they do not do for is in no stack.
uniform usamplerBuffer bodyOrder;

uint mostRounds()
{
    return STACK_TURNS / (2u * BODY_TURNS * (1u + sim.freeBodyCount / STACK_GROUP)) + 2u;
}

uint roundsLeft = mostRounds();

#define FOR_BODIES(b) \
    for (uint k = gl_LocalInvocationID.x, b; k < sim.freeBodyCount && (b = texelFetch(bodyOrder, int(k)).x) != NONE; \
         k += STACK_GROUP)

#define MEET memoryBarrierBuffer(); memoryBarrierShared(); barrier();

#define BEGIN_ROUND \
    MEET \
    if (gl_LocalInvocationID.x == 0u) changed = 0u; \
    MEET

/// Whether there is another round, behind the last barrier of one. All threads agree.
bool goesOn()
{
    if (roundsLeft > 0u) --roundsLeft;
    return changed != 0u && roundsLeft > 0u;
}
