// Sums of the impulses on a mover: of a linear field, p and p r^T.
#include "sim/common/fields.glsl"
#include "sim/common/list_ranges.glsl"
#include "sim/common/links.glsl"

#ifndef PAIR_IMPULSES
#define PAIR_IMPULSES pairImpulses
#define COLLIDER_IMPULSES colliderImpulses
#endif
uniform samplerBuffer PAIR_IMPULSES;
uniform samplerBuffer pairArms;
uniform usamplerBuffer pairReferences;
uniform samplerBuffer COLLIDER_IMPULSES;
uniform samplerBuffer colliderArms;
uniform samplerBuffer linkImpulses;
#ifdef ON_PARTICLES
uniform samplerBuffer particleImpulses;  // by rank
uniform samplerBuffer restOffsets;
uniform usamplerBuffer rankedParticles;
#endif

struct Sum {
    Field impulse;
    float acting;
};

void add(inout Sum sum, vec4 impulse, float side, vec3 r)
{
    vec3 p = side * impulse.xyz;
    sum.impulse.t += p;
    sum.impulse.f += outerProduct(p, r);
    sum.acting += impulse.w != 0.0 ? 1.0 : 0.0;
}

/// What its contacts add to a mover, and how many will act next.
Sum contactSum(uvec4 info, uint parity)
{
    Sum sum = Sum(Field(vec3(0), mat3(0)), 0.0);
    int pairBase = int(parity * sim.pairCapacity), colliderBase = int(parity * sim.colliderPairCapacity);
    uvec2 range = listRange(parity, LIST_AS_FIRST, info.x, info.y);
    for (int q = int(range.x); q < int(range.y); ++q)
        add(sum, texelFetch(PAIR_IMPULSES, pairBase + q), 1.0, texelFetch(pairArms, 2 * q).xyz);
    range = listRange(parity, LIST_AS_SECOND, info.x, info.y);
    for (uint k = range.x; k < range.y; ++k) {
        uint reference = texelFetch(pairReferences, int(k)).x;
        int q = int(min(reference, sim.pairCapacity - 1u));
        vec4 impulse = reference == NO_PAIR ? vec4(0) : texelFetch(PAIR_IMPULSES, pairBase + q);
        add(sum, impulse, -1.0, texelFetch(pairArms, 2 * q + 1).xyz);
    }
    range = listRange(parity, LIST_COLLIDERS, info.x, info.y);
    for (int q = int(range.x); q < int(range.y); ++q)
        add(sum, texelFetch(COLLIDER_IMPULSES, colliderBase + q), 1.0, texelFetch(colliderArms, q).xyz);
    return sum;
}

/// What its joints add to a body (WARM_START: nothing).
Field jointSum(uvec4 body)
{
    Field sum = Field(vec3(0), mat3(0));
#ifndef WARM_START
    for (uint l = body.x + body.z; l < body.x + body.y; ++l) {
        vec3 p = texelFetch(linkImpulses, int(l)).xyz;
        sum.t += p;
        sum.f += outerProduct(p, fetchLink(l).r);
    }
#endif
    return sum;
}

/// What fluids, ropes and soft bodies add to a mover through its particles (ON_PARTICLES: of a world that has any).
Field particleSum(uvec4 info)
{
    Field sum = Field(vec3(0), mat3(0));
#ifdef ON_PARTICLES
    for (uint rank = info.x; rank < info.x + info.y; ++rank) {
        vec3 p = texelFetch(particleImpulses, int(rank)).xyz;
        sum.t += p;
        sum.f += outerProduct(p, texelFetch(restOffsets, int(texelFetch(rankedParticles, int(rank)).x)).xyz);
    }
#endif
    return sum;
}
