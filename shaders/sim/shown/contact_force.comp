// One thread a solid particle, by rank: adds the sizes of the forces that its contacts gave it in the substep, as its
// share of their mean over the step [N]. FIRST: the first substep of a step. Sizes, so that what presses from two sides
// does not cancel.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/given_impulses.glsl"
#include "sim/common/contacts/listed_pairs.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(float, ContactForces, contactForces);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint rank = gl_GlobalInvocationID.x;
    if (rank >= sim.particleCount) return;
    uint parity = counters[0].listParity;
    float sum = 0.0;
    ListedPairs list = pairsOf(rank, 1u, parity);
    for (uint k = 0u; k < list.count; ++k) {
        uint index = pairAt(list, k, parity).index;
        if (index != NONE) sum += length(pairGave(index));
    }
    uvec2 range = listRange(parity, LIST_COLLIDERS, rank, 1u);
    for (uint q = range.x; q < range.y; ++q) sum += length(colliderGave(parity * sim.colliderPairCapacity + q));
    uint i = fetchRankedParticle(rank);
    float share = sum / (float(sim.substeps) * sim.substepTime);
#ifdef FIRST
    contactForces[i] = share;
#else
    contactForces[i] += share;
#endif
}
