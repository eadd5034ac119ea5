// Sums of the impulses on a mover that each search finds anew, or that act on its particles, as linear fields: p and p
// r^T.
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/bodies/mover_info.glsl"

#ifndef PAIR_IMPULSES
#define PAIR_IMPULSES pairImpulses
#define COLLIDER_IMPULSES colliderImpulses
#endif
uniform samplerBuffer PAIR_IMPULSES;
uniform samplerBuffer pairArms;
uniform usamplerBuffer pairReferences;
uniform samplerBuffer COLLIDER_IMPULSES;
uniform samplerBuffer colliderArms;
#ifdef SKIPS_ROPES
uniform usamplerBuffer colliderSides;
#endif
#ifdef ON_PARTICLES
uniform samplerBuffer particleImpulses;  // by rank
#endif

struct Sum {
    Field impulse;
    float acting;    // how many of the contacts act
};

/// @param side 1 for the first side of a contact, -1 for the second.
void add(inout Sum sum, Impulse impulse, float side, Arm arm)
{
    vec3 p = side * impulse.whole;
    sum.impulse.t += p;
    sum.impulse.f += outerProduct(p, arm.r);
    sum.acting += impulse.normal != 0.0 ? 1.0 : 0.0;
}

/// Sum of the impulses of a mover's contacts, and the number of contacts that will act next.
Sum contactSum(Mover mover, uint parity)
{
    Sum sum = Sum(Field(vec3(0), mat3(0)), 0.0);
    uint pairBase = parity * sim.pairCapacity, colliderBase = parity * sim.colliderPairCapacity;
    uvec2 range = listRange(parity, LIST_AS_FIRST, mover.firstRank, mover.rankCount);
    for (uint q = range.x; q < range.y; ++q)
        add(sum, fetchImpulse(PAIR_IMPULSES, pairBase + q), 1.0, fetchContactArm(pairArms, firstArm(q)));
    range = listRange(parity, LIST_AS_SECOND, mover.firstRank, mover.rankCount);
    for (uint k = range.x; k < range.y; ++k) {
        uint reference = texelFetch(pairReferences, int(k)).x;
        uint q = min(reference, sim.pairCapacity - 1u);
        Impulse impulse = fetchImpulse(PAIR_IMPULSES, pairBase + q);
        if (reference == NONE) impulse = Impulse(vec3(0), 0.0);   // there was no room for the pair
        add(sum, impulse, -1.0, fetchContactArm(pairArms, secondArm(q)));
    }
    range = listRange(parity, LIST_COLLIDERS, mover.firstRank, mover.rankCount);
    for (uint q = range.x; q < range.y; ++q) {
#ifdef SKIPS_ROPES
        if (fetchColliderContact(colliderSides, q).ofRope) continue;
#endif
        add(sum, fetchImpulse(COLLIDER_IMPULSES, colliderBase + q), 1.0, fetchContactArm(colliderArms, q));
    }
    return sum;
}

/// Sum of the impulses of fluids, ropes and soft bodies on a mover's particles (ON_PARTICLES: of a world that has any).
Field particleSum(Mover mover)
{
    Field sum = Field(vec3(0), mat3(0));
#ifdef ON_PARTICLES
    for (uint rank = mover.firstRank; rank < mover.firstRank + mover.rankCount; ++rank) {
        vec3 p = texelFetch(particleImpulses, int(rank)).xyz;
        sum.t += p;
        sum.f += outerProduct(p, fetchArm(fetchRankedParticle(rank)).r);
    }
#endif
    return sum;
}
