// The sum of what a particle's contacts ask of it.
#include "sim/common/contacts/colliders.glsl"
#include "sim/common/contacts/list_ranges.glsl"
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

/// What a contact with a collider asks of a particle. @param radius of the particle [m].
Push colliderPush(Side own, ColliderContact contact, float radius)
{
    ColliderSurface surface = colliderSurface(contact.collider, own.start + own.move);
    float startGap = colliderSurface(contact.collider, own.start).distance - radius;
    Push push = contactPush(surface.normal, surface.distance - radius, startGap, own.move, contact.friction);
    push.move *= own.inverseMass > 0.0 ? 1.0 : 0.0;
    return push;
}

void add(inout Push sum, Push other)
{
    sum.move += other.move;
    sum.acting += other.acting;
}

/// The sums over the three lists of a particle.
Push allPushes(uint i, Side own, uint parity, uint rank)
{
    Push sum = Push(vec3(0), 0.0);
    uint base = parity * sim.pairCapacity;
    uvec2 range = listRange(parity, LIST_AS_FIRST, rank, 1u);
    for (uint q = range.x; q < range.y; ++q) {
        uint other = fetchPair(pairs, base + q).second;
        add(sum, pairPush(own, fetchSide(other), true, fetchContactSides(pairSides, q), sim.diameter));
    }
    range = listRange(parity, LIST_AS_SECOND, rank, 1u);
    for (uint k = range.x; k < range.y; ++k) {
        uint q = texelFetch(pairReferences, int(k)).x;
        if (q == NONE) continue;
        uint other = fetchPair(pairs, base + q).first;
        add(sum, pairPush(own, fetchSide(other), false, fetchContactSides(pairSides, q), sim.diameter));
    }
    range = listRange(parity, LIST_COLLIDERS, rank, 1u);
    for (uint q = range.x; q < range.y; ++q)
        add(sum, colliderPush(own, fetchColliderContact(colliderSides, q), 0.5 * sim.diameter));
    return sum;
}
