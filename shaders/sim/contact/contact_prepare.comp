// One thread a pair of particles: what its contact is made of, with the impulse that it had before.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/contact/exit_direction.glsl"
#include "sim/common/contacts/touch.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer latticeEnds;
uniform samplerBuffer searchPositions;
uniform usamplerBuffer pairs;
uniform samplerBuffer lastPairImpulses;
uniform samplerBuffer lastPairMeans;
uniform usamplerBuffer pairArrivals;     // by second particle, in the order of arrival, which differs from run to run
BUFFER(uvec4, PairSides, pairSides);
BUFFER(vec4, PairArms, pairArms);
BUFFER(vec4, PairImpulses, pairImpulses);
BUFFER(float, PairMeans, pairMeans);
BUFFER(uint, PairReferences, pairReferences);
BUFFER(Counters, CountersBlock, counters);

/// A mass of balls that slide on each other and cannot turn has pi / 2 times their friction (Caquot 1934). As the
/// material's friction is to be that of the mass, loose particles get less.
#define LOOSE_FRICTION 0.63662

/// What a pair had before.
struct Old {
    Impulse impulse;
    float mean;
};

/// Of a pair with those ranks, whichever of the two was the first.
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

/// The second particle refers to its pairs in their order, so that what is summed over them is summed in one order.
void refer(uint parity, uint q, uint secondRank)
{
    uvec2 range = listRange(parity, LIST_AS_SECOND, secondRank, 1u);
    uint index = range.x;
    for (uint k = range.x; k < range.y; ++k) index += texelFetch(pairArrivals, int(k)).x < q ? 1u : 0u;
    pairReferences[index] = q;
}

/// The hidden axes of a particle's lattice for what is at `towards` from it [m]. @param rotation of its body.
uint hiddenBeside(uint i, vec4 rotation, vec3 towards)
{
    return hiddenAxes(texelFetch(latticeEnds, int(i)).x, rotate(conjugate(rotation), towards), 2.0 * particleRadius(i));
}

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint parity = counters[0].listParity, index = parity * sim.pairCapacity + q;
    Pair pair = fetchPair(pairs, index);
    ParticleRank a = fetchRank(pair.first), b = fetchRank(pair.second);
    Arm armA = fetchArm(pair.first), armB = fetchArm(pair.second);
    float touch = touchDistance(pair.first, pair.second);
    vec3 difference = texelFetch(searchPositions, int(pair.first)).xyz -
                      texelFetch(searchPositions, int(pair.second)).xyz;
    vec4 rotationA = texelFetch(searchRotations, int(a.mover)), rotationB = texelFetch(searchRotations, int(b.mover));
    ContactSides sides;
    sides.movers = uvec2(a.mover, b.mover);
    sides.exit = exitDirection(pair, sides.movers, touch);
    sides.hidden = hiddenBeside(pair.first, rotationA, -difference) |
                   hiddenBeside(pair.second, rotationB, difference) << 3;
    Separation separation = separationOf(difference, sides.exit, rotationA, rotationB, sides.hidden, touch);
    sides.friction = 0.5 * (fetchMass(pair.first).friction + fetchMass(pair.second).friction);
    if (min(a.mover, b.mover) >= sim.bodyCount) sides.friction *= LOOSE_FRICTION;
    sides.fractions =
        vec2(normalFraction(a.mover, armA, separation.normal), normalFraction(b.mover, armB, separation.normal));
    pairSides[q] = packContactSides(sides);
    pairArms[firstArm(q)] = packArm(armA);
    pairArms[secondArm(q)] = packArm(armB);
    Old old = oldImpulse(parity ^ 1u, pair, a.rank, b.rank);
    if (separation.distance < touch && old.impulse.normal <= 0.0) old.impulse.normal = ABOUT_TO_ACT;
    pairImpulses[index] = packImpulse(old.impulse);
    pairMeans[index] = old.mean;
    refer(parity, q, b.rank);
}
