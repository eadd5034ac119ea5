// What a search for contacts knows about particles, and where it notes what it finds.
#include "sim/common/contacts/contact_lists.glsl"
#include "sim/common/bodies/owners.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/search/candidates.glsl"
#include "sim/search/sorted_particles.glsl"

uniform samplerBuffer sortedPositions;
uniform usamplerBuffer sortedInfos;
uniform usamplerBuffer cellStarts;
uniform samplerBuffer restPositions;
BUFFER(uvec2, FirstLists, firstLists);   // candidates
BUFFER(uint, ListCounts, listCounts);
BUFFER(Counters, CountersBlock, counters);

SortedPosition fetchSortedPosition(uint k)
{
    return unpackSortedPosition(texelFetch(sortedPositions, int(k)));
}

SortedInfo fetchSortedInfo(uint k)
{
    return unpackSortedInfo(texelFetch(sortedInfos, int(k)));
}

/// Where a particle is in its assembly.
struct RestPosition {
    vec3 position;   // in the rest pose [m]
    float margin;    // nearer than 1 + this there, in distances of touch, particles never touch
};

RestPosition fetchRestPosition(uint i)
{
    vec4 t = texelFetch(restPositions, int(i));
    return RestPosition(t.xyz, t.w);
}

bool inSameBody(uint i, uint j)
{
    OwnerRange a = fetchOwners(i), b = fetchOwners(j);
    bool same = false;
    for (uint k = 0u; k < a.count; ++k)
        for (uint l = 0u; l < b.count; ++l)
            same = same || fetchOwner(a.first + k).body == fetchOwner(b.first + l).body;
    return same;
}

/// For two particles of one assembly: only where they do not touch or overlap at rest.
bool mayTouch(uint i, uint j)
{
    RestPosition a = fetchRestPosition(i), b = fetchRestPosition(j);
    float least = (0.99 + max(a.margin, b.margin)) * touchDistance(i, j);
    return length(a.position - b.position) > least && !inSameBody(i, j);
}

/// Lists `other` as the second of a pair whose first is `own`, which has `count` before it.
void notePair(SortedInfo own, SortedInfo other, uint count)
{
    if (count >= sim.contactSlots) return;
    uint arrival = atomicAdd(listCounts[listIndex(LIST_AS_SECOND, other.rank)], 1u);
    firstLists[candidateIndex(count, own.particle)] = packCandidate(Candidate(other.particle, arrival));
}

void noteCount(SortedInfo own, uint count)
{
    if (count > sim.contactSlots) {
        atomicOr(counters[0].problems, PROBLEM_CONTACTS);
        atomicMax(counters[0].wantedContacts, count);
    }
    listCounts[listIndex(LIST_AS_FIRST, own.rank)] = min(count, sim.contactSlots);
}
