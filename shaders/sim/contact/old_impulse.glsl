// Impulses of pairs before the search that found them anew.
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/list_ranges.glsl"

uniform usamplerBuffer pairs;
uniform samplerBuffer lastPairImpulses;
uniform samplerBuffer lastPairMeans;

/// Old impulse of a pair, and its mean.
struct Old {
    Impulse impulse;
    float mean;
};

/// The old impulse of a pair with those ranks, whichever of the two was the first.
Old oldImpulse(uint parity, Pair pair, uint firstRank, uint secondRank)
{
    uvec2 ofFirst = listRange(parity, LIST_AS_FIRST, firstRank, 1u);
    uvec2 ofSecond = listRange(parity, LIST_AS_FIRST, secondRank, 1u);
    uint firstCount = ofFirst.y - ofFirst.x;
    uint count = firstCount + ofSecond.y - ofSecond.x;
    uint index = 0u;
    float side = 0.0;
    for (uint k = 0u; k < count; ++k) {
        bool isFirst = k < firstCount;
        uint q = isFirst ? ofFirst.x + k : ofSecond.x + k - firstCount;
        uint other = fetchPair(pairs, parity * sim.pairCapacity + q).second;
        bool same = other == (isFirst ? pair.second : pair.first);
        index = same ? q : index;
        side = same ? (isFirst ? 1.0 : -1.0) : side;
    }
    uint old = parity * sim.pairCapacity + index;
    Impulse impulse = fetchImpulse(lastPairImpulses, old);
    return Old(Impulse(side * impulse.whole, abs(side) * impulse.normal),
               abs(side) * texelFetch(lastPairMeans, int(old)).x);
}
