// One thread a pair of particles: what its contact is made of, with the impulse that it had before.
#include "sim/common/kernel.glsl"
#include "sim/common/list_ranges.glsl"
#include "sim/contact/exit_direction.glsl"
#include "sim/common/flat_faces.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer latticeEnds;
uniform samplerBuffer restOffsets;
uniform samplerBuffer masses;
uniform samplerBuffer searchPositions;
uniform usamplerBuffer pairs;
uniform samplerBuffer lastPairImpulses;
uniform samplerBuffer lastPairMeans;
uniform usamplerBuffer pairArrivals;     // by second particle, in the order of arrival, which differs from run to run
BUFFER(uvec4, PairSides, pairSides);     // movers with the way out, frictions, shares of inverse masses with hidden axes
BUFFER(vec4, PairArms, pairArms);        // two a pair: place in the body, worst inverse mass there
BUFFER(vec4, PairImpulses, pairImpulses);
BUFFER(float, PairMeans, pairMeans);
BUFFER(uint, PairReferences, pairReferences);
BUFFER(Counters, CountersBlock, counters);

/// What a pair had before.
struct Old {
    vec4 impulse;
    float mean;
};

/// Of the pair (i, j), whichever of the two was first.
Old oldImpulse(uint parity, uint i, uint j, uint rankOfI, uint rankOfJ)
{
    uvec2 pairsOfI = listRange(parity, LIST_AS_FIRST, rankOfI, 1u);
    uvec2 pairsOfJ = listRange(parity, LIST_AS_FIRST, rankOfJ, 1u);
    uint countOfI = pairsOfI.y - pairsOfI.x;
    uint count = countOfI + pairsOfJ.y - pairsOfJ.x;
    uint place = 0u;
    float side = 0.0;
    for (uint k = 0u; k < count; ++k) {
        bool ofI = k < countOfI;
        uint q = ofI ? pairsOfI.x + k : pairsOfJ.x + k - countOfI;
        bool same = texelFetch(pairs, int(parity * sim.pairCapacity + q)).y == (ofI ? j : i);
        place = same ? q : place;
        side = same ? (ofI ? 1.0 : -1.0) : side;
    }
    int at = int(parity * sim.pairCapacity + place);
    vec4 impulse = texelFetch(lastPairImpulses, at);
    return Old(vec4(side * impulse.xyz, abs(side) * impulse.w), abs(side) * texelFetch(lastPairMeans, at).x);
}

/// The second particle refers to its pairs in their order, so that what is summed over them is summed in one order.
void refer(uint parity, uint q, uint rankOfJ)
{
    uvec2 range = listRange(parity, LIST_AS_SECOND, rankOfJ, 1u);
    uint place = range.x;
    for (uint k = range.x; k < range.y; ++k) place += texelFetch(pairArrivals, int(k)).x < q ? 1u : 0u;
    pairReferences[place] = q;
}

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint parity = counters[0].listParity;
    uvec2 pair = texelFetch(pairs, int(parity * sim.pairCapacity + q)).xy;
    int i = int(pair.x), j = int(pair.y);
    uvec2 a = texelFetch(particleRanks, i).xy, b = texelFetch(particleRanks, j).xy;
    vec4 armA = texelFetch(restOffsets, i), armB = texelFetch(restOffsets, j);
    vec3 apart = texelFetch(searchPositions, i).xyz - texelFetch(searchPositions, j).xyz;
    Way way = wayOut(i, j, uvec2(a.x, b.x), apart);
    vec4 turnA = texelFetch(searchRotations, int(a.x)), turnB = texelFetch(searchRotations, int(b.x));
    uint hidden = hiddenAxes(texelFetch(latticeEnds, i).x, rotate(conjugate(turnA), -apart)) |
                  hiddenAxes(texelFetch(latticeEnds, j).x, rotate(conjugate(turnB), apart)) << 3;
    Parting parting = partingOf(apart, way, turnA, turnB, hidden);
    uvec2 movers = uvec2(a.x, b.x) | packWay(way);
    vec2 friction = 0.5 * (texelFetch(masses, i).zw + texelFetch(masses, j).zw);
    // A mass of balls that slide on each other and cannot turn has pi / 2 times their friction (Caquot 1934): that is
    // what the material's friction is to be.
    if (min(a.x, b.x) >= sim.bodyCount) friction *= 0.63662;
    vec2 shares = vec2(normalFraction(a.x, armA, parting.normal), normalFraction(b.x, armB, parting.normal));
    pairSides[q] = uvec4(movers, packHalf2x16(friction), packFractions(shares, hidden));
    pairArms[2u * q] = armA;
    pairArms[2u * q + 1u] = armB;
    Old old = oldImpulse(parity ^ 1u, pair.x, pair.y, a.y, b.y);
    if (parting.far < sim.diameter && old.impulse.w <= 0.0) old.impulse.w = ABOUT_TO_ACT;
    pairImpulses[parity * sim.pairCapacity + q] = old.impulse;
    pairMeans[parity * sim.pairCapacity + q] = old.mean;
    refer(parity, q, b.y);
}
