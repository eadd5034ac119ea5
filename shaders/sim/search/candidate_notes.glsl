// Storage for what the search finds.
#include "sim/common/contacts/contact_lists.glsl"
#include "sim/search/candidates.glsl"

BUFFER(uvec4, Candidates, candidates);
BUFFER(uint, ListCounts, listCounts);
BUFFER(Counters, CountersBlock, counters);

void note(Candidate candidate)
{
    uint index = atomicAdd(counters[0].candidateCount, 1u);
    if (index < sim.candidateCapacity) candidates[index] = packCandidate(candidate);
}
