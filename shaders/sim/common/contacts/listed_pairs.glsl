// The contacts of a body, or of one particle, with other particles, one after another.
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/list_ranges.glsl"

uniform usamplerBuffer pairs;
uniform usamplerBuffer pairReferences;

/// Where the contacts of some ranks in a row stand in the lists.
struct ListedPairs {
    uvec2 asFirst, asSecond;
    uint count;
};

ListedPairs pairsOf(uint firstRank, uint rankCount, uint parity)
{
    uvec2 first = listRange(parity, LIST_AS_FIRST, firstRank, rankCount);
    uvec2 second = listRange(parity, LIST_AS_SECOND, firstRank, rankCount);
    return ListedPairs(first, second, first.y - first.x + second.y - second.x);
}

/// A contact, seen from one of those ranks.
struct ListedPair {
    uint index;          // of its impulse; NONE if there was no room for it
    uint own, other;     // particles
    float side;          // 1: the own particle is the first, else -1
};

ListedPair pairAt(ListedPairs list, uint k, uint parity)
{
    uint firsts = list.asFirst.y - list.asFirst.x;
    bool isFirst = k < firsts;
    uint q = list.asFirst.x + k;
    if (!isFirst) q = texelFetch(pairReferences, int(list.asSecond.x + k - firsts)).x;
    if (q == NONE) return ListedPair(NONE, 0u, 0u, 0.0);
    Pair pair = fetchPair(pairs, parity * sim.pairCapacity + q);
    return ListedPair(parity * sim.pairCapacity + q, isFirst ? pair.first : pair.second,
                      isFirst ? pair.second : pair.first, isFirst ? 1.0 : -1.0);
}
