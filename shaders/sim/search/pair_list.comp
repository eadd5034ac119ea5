// One thread a particle: puts the pairs of which it is the first into their list, and has the second particles refer to
// them. The first thread sets the sizes of the lists.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/particles.glsl"
#include "sim/search/candidates.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer firstLists;       // candidates
uniform usamplerBuffer colliderLists;
uniform usamplerBuffer listCounts;
BUFFER(uvec2, Pairs, pairs);             // first and second particle
BUFFER(uint, PairArrivals, pairArrivals);
BUFFER(uint, PairReferences, pairReferences);   // contact_prepare puts them in order
BUFFER(uvec2, ColliderPairs, colliderPairs);    // particle, collider
BUFFER(uvec4, Dispatches, dispatches);
BUFFER(Counters, CountersBlock, counters);

void setSizes(uint parity)
{
    uint total = listTotal(parity, LIST_AS_FIRST), withColliders = listTotal(parity, LIST_COLLIDERS);
    counters[0].pairCount = min(total, sim.pairCapacity);
    counters[0].colliderPairCount = min(withColliders, sim.colliderPairCapacity);
    counters[0].wantedPairs = max(counters[0].wantedPairs, total);
    counters[0].wantedColliderPairs = max(counters[0].wantedColliderPairs, withColliders);
    if (total > sim.pairCapacity || withColliders > sim.colliderPairCapacity)
        atomicOr(counters[0].problems, PROBLEM_PAIRS);
    uvec4 pairGroups = uvec4(groups(counters[0].pairCount), 1, 1, 0);
    uvec4 colliderGroups = uvec4(groups(counters[0].colliderPairCount), 1, 1, 0);
    dispatches[DISPATCH_PAIRS] = dispatches[DISPATCH_NEW_PAIRS] = pairGroups;
    dispatches[DISPATCH_COLLIDER_PAIRS] = dispatches[DISPATCH_NEW_COLLIDER_PAIRS] = colliderGroups;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uint parity = counters[0].listParity;
    if (i == 0u) setSizes(parity);
    uint rank = fetchRank(i).rank;
    uint first = listEntry(parity, rank), end = listEntry(parity, rank + 1u);
    uint references = listEntry(parity, listIndex(LIST_AS_SECOND, 0u));
    for (uint q = first; q < end; ++q) {
        Candidate candidate = unpackCandidate(texelFetch(firstLists, int(candidateIndex(q - first, i))).xy);
        uint other = fetchRank(candidate.second).rank;
        if (q < sim.pairCapacity) pairs[parity * sim.pairCapacity + q] = uvec2(i, candidate.second);
        uint index = listEntry(parity, listIndex(LIST_AS_SECOND, other)) - references + candidate.arrival;
        pairArrivals[index] = q;
        pairReferences[index] = NONE;
    }
    uvec2 range = listRange(parity, LIST_COLLIDERS, rank, 1u) + parity * sim.colliderPairCapacity;
    for (uint q = range.x; q < range.y; ++q)
        colliderPairs[q] = uvec2(i, texelFetch(colliderLists, int(candidateIndex(q - range.x, i))).x);
}
