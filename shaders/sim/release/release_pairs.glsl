// The contacts of a body with other particles, one after another.
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/list_ranges.glsl"

uniform usamplerBuffer pairs;
uniform usamplerBuffer pairReferences;

/// Where a body's contacts stand in the lists.
struct BodyPairs {
    uvec2 asFirst, asSecond;
    uint count;
};

BodyPairs pairsOf(Mover body, uint parity)
{
    uvec2 first = listRange(parity, LIST_AS_FIRST, body.firstRank, body.rankCount);
    uvec2 second = listRange(parity, LIST_AS_SECOND, body.firstRank, body.rankCount);
    return BodyPairs(first, second, first.y - first.x + second.y - second.x);
}

/// A contact, seen from the body.
struct BodyPair {
    uint index;          // of its impulse; NONE if there was no room for it
    uint own, other;     // particles
    float side;          // 1: the body's particle is the first, else -1
};

BodyPair pairAt(BodyPairs list, uint k, uint parity)
{
    uint firsts = list.asFirst.y - list.asFirst.x;
    bool isFirst = k < firsts;
    uint q = list.asFirst.x + k;
    if (!isFirst) q = texelFetch(pairReferences, int(list.asSecond.x + k - firsts)).x;
    if (q == NONE) return BodyPair(NONE, 0u, 0u, 0.0);
    Pair pair = fetchPair(pairs, parity * sim.pairCapacity + q);
    return BodyPair(parity * sim.pairCapacity + q, isFirst ? pair.first : pair.second,
                    isFirst ? pair.second : pair.first, isFirst ? 1.0 : -1.0);
}

/// Whether a mover belongs to another object than the body that a release watches.
bool isAnother(Release release, uint mover)
{
    return mover < release.firstBody || mover >= release.bodyEnd;
}
