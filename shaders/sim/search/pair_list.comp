// One thread a candidate: puts it into its list, and has a pair's second particle refer to it. The first thread sets
// the sizes of the lists.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/particles.glsl"
#include "sim/search/candidates.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer candidates;
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
    counters[0].wantedCandidates = max(counters[0].wantedCandidates, counters[0].candidateCount);
    if (counters[0].candidateCount > sim.candidateCapacity) atomicOr(counters[0].problems, PROBLEM_CANDIDATES);
    if (total > sim.pairCapacity || withColliders > sim.colliderPairCapacity)
        atomicOr(counters[0].problems, PROBLEM_PAIRS);
    uvec4 pairGroups = uvec4(groups(counters[0].pairCount), 1, 1, 0);
    uvec4 colliderGroups = uvec4(groups(counters[0].colliderPairCount), 1, 1, 0);
    dispatches[DISPATCH_PAIRS] = dispatches[DISPATCH_NEW_PAIRS] = pairGroups;
    dispatches[DISPATCH_COLLIDER_PAIRS] = dispatches[DISPATCH_NEW_COLLIDER_PAIRS] = colliderGroups;
}

void listPair(uint parity, Candidate candidate, uint q)
{
    if (q < sim.pairCapacity) pairs[parity * sim.pairCapacity + q] = uvec2(candidate.first, candidate.second);
    uint second = listIndex(LIST_AS_SECOND, fetchRank(candidate.second).rank);
    uint index = listEntry(parity, second) - listEntry(parity, listIndex(LIST_AS_SECOND, 0u)) + candidate.arrival;
    if (index >= sim.candidateCapacity) return;
    pairArrivals[index] = q;
    pairReferences[index] = NONE;
}

void main()
{
    uint k = gl_GlobalInvocationID.x, parity = counters[0].listParity;
    if (k == 0u) setSizes(parity);
    if (k >= min(counters[0].candidateCount, sim.candidateCapacity)) return;
    Candidate candidate = unpackCandidate(texelFetch(candidates, int(k)));
    uint rank = fetchRank(candidate.first).rank;
    if (candidate.arrival != NONE) {
        listPair(parity, candidate, listEntry(parity, rank) + candidate.place);
    } else {
        uvec2 range = listRange(parity, LIST_COLLIDERS, rank, 1u);
        if (range.x + candidate.place >= range.y) return;
        colliderPairs[parity * sim.colliderPairCapacity + range.x + candidate.place] =
            uvec2(candidate.first, candidate.second);
    }
}
