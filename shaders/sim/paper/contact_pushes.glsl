// What all contacts of a particle ask of it together.
#include "sim/common/colliders.glsl"
#include "sim/common/list_ranges.glsl"
#include "sim/paper/averaged_contact.glsl"
#include "sim/paper/predicted_moves.glsl"

uniform samplerBuffer predicted;
uniform samplerBuffer positions;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform usamplerBuffer pairReferences;
uniform usamplerBuffer colliderSides;

Side fetchSide(uint i)
{
    PredictedMove so = predictedMove(texelFetch(predicted, int(i)));
    return Side(texelFetch(positions, int(i)).xyz, so.move, so.contactInverseMass);
}

/// @param radius  Nearer to the collider than this the particle overlaps it [m].
Push colliderPush(Side own, uvec4 sides, float radius)
{
    vec4 surface = colliderDistance(sides.y, own.start + own.move);
    float startGap = colliderDistance(sides.y, own.start).w - radius;
    Push push = contactPush(surface.xyz, surface.w - radius, startGap, own.move, unpackHalf2x16(sides.z));
    push.move *= own.inverseMass > 0.0 ? 1.0 : 0.0;
    return push;
}

void add(inout Push sum, Push other)
{
    sum.move += other.move;
    sum.acting += other.acting;
}

/// The sums over the three lists of a particle. @param touching  Particles nearer to each other than this overlap [m].
Push allPushes(Side own, uint parity, uint rank, float touching)
{
    Push sum = Push(vec3(0), 0.0);
    uint base = parity * sim.pairCapacity;
    uvec2 range = listRange(parity, LIST_AS_FIRST, rank, 1u);
    for (uint q = range.x; q < range.y; ++q) {
        Side other = fetchSide(texelFetch(pairs, int(base + q)).y);
        add(sum, pairPush(own, other, true, texelFetch(pairSides, int(q)), touching));
    }
    range = listRange(parity, LIST_AS_SECOND, rank, 1u);
    for (uint k = range.x; k < range.y; ++k) {
        uint q = texelFetch(pairReferences, int(k)).x;
        if (q == NONE) continue;
        Side other = fetchSide(texelFetch(pairs, int(base + q)).x);
        add(sum, pairPush(own, other, false, texelFetch(pairSides, int(q)), touching));
    }
    range = listRange(parity, LIST_COLLIDERS, rank, 1u);
    for (uint q = range.x; q < range.y; ++q)
        add(sum, colliderPush(own, texelFetch(colliderSides, int(q)), 0.5 * touching));
    return sum;
}
