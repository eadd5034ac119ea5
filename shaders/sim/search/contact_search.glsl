// What a search for contacts knows about particles, and where it notes what it finds.
#include "sim/common/contact_lists.glsl"

uniform samplerBuffer sortedPositions;
uniform usamplerBuffer sortedInfos;      // particle, assembly, rank, 1 if fast
uniform usamplerBuffer cellStarts;
uniform samplerBuffer restPositions;
uniform usamplerBuffer particleLinks;    // first entry and count in linksOfParticle
uniform usamplerBuffer linksOfParticle;  // link, its body
BUFFER(uvec2, FirstLists, firstLists);   // second particle, its arrival among that one's references
BUFFER(uint, ListCounts, listCounts);
BUFFER(Counters, CountersBlock, counters);

bool inSameBody(uint i, uint j)
{
    uvec2 a = texelFetch(particleLinks, int(i)).xy, b = texelFetch(particleLinks, int(j)).xy;
    bool same = false;
    for (uint k = 0u; k < a.y; ++k)
        for (uint l = 0u; l < b.y; ++l)
            same = same || texelFetch(linksOfParticle, int(a.x + k)).y == texelFetch(linksOfParticle, int(b.x + l)).y;
    return same;
}

/// For two particles of one assembly.
bool mayTouch(uint i, uint j)
{
    vec4 a = texelFetch(restPositions, int(i)), b = texelFetch(restPositions, int(j));
    return length(a.xyz - b.xyz) > (0.99 + max(a.w, b.w)) * sim.diameter && !inSameBody(i, j);
}

/// Lists `other` (of sortedInfos) as the second of a pair with the particle `own`, which has `count` before it.
void notePair(uvec4 own, uvec4 other, uint count)
{
    if (count >= sim.contactSlots) return;
    uint arrival = atomicAdd(listCounts[listPlace(LIST_AS_SECOND, other.z)], 1u);
    firstLists[count * sim.particleCount + own.x] = uvec2(other.x, arrival);
}

void noteCount(uvec4 own, uint count)
{
    if (count > sim.contactSlots) {
        atomicOr(counters[0].problems, PROBLEM_CONTACTS);
        atomicMax(counters[0].wantedContacts, count);
    }
    listCounts[listPlace(LIST_AS_FIRST, own.z)] = min(count, sim.contactSlots);
}
