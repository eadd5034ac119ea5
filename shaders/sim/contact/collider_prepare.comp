// One thread a contact of a particle with a collider: what it is made of, with the impulse that it had before.
#include "sim/common/kernel.glsl"
#include "sim/common/list_ranges.glsl"
#include "sim/common/colliders.glsl"
#include "sim/contact/contact_mass.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform samplerBuffer restOffsets;
uniform samplerBuffer masses;
uniform samplerBuffer searchPositions;
uniform usamplerBuffer colliderPairs;    // particle, collider
uniform samplerBuffer lastColliderImpulses;
uniform samplerBuffer lastColliderMeans;
BUFFER(uvec4, ColliderSides, colliderSides);   // mover, collider, frictions, share of inverse mass
BUFFER(vec4, ColliderArms, colliderArms);
BUFFER(vec4, ColliderImpulses, colliderImpulses);
BUFFER(float, ColliderMeans, colliderMeans);
BUFFER(Counters, CountersBlock, counters);

/// Where the contact stood before; -1: nowhere.
int oldPlace(uint parity, uint rank, uint collider)
{
    uvec2 range = listRange(parity, LIST_COLLIDERS, rank, 1u) + parity * sim.colliderPairCapacity;
    for (uint q = range.x; q < range.y; ++q)
        if (texelFetch(colliderPairs, int(q)).y == collider) return int(q);
    return -1;
}

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].colliderPairCount) return;
    uint parity = counters[0].listParity;
    uint place = parity * sim.colliderPairCapacity + q;
    uvec2 pair = texelFetch(colliderPairs, int(place)).xy;
    int i = int(pair.x);
    uvec2 own = texelFetch(particleRanks, i).xy;
    vec4 arm = texelFetch(restOffsets, i);
    vec4 surface = colliderDistance(pair.y, texelFetch(searchPositions, i).xyz);
    vec2 friction = 0.5 * (texelFetch(masses, i).zw + colliderAt(pair.y).friction.xy);
    vec2 shares = vec2(normalFraction(own.x, arm, surface.xyz), 1);
    colliderSides[q] = uvec4(own.x, pair.y, packHalf2x16(friction), packUnorm2x16(shares));
    colliderArms[q] = arm;
    int old = oldPlace(parity ^ 1u, own.y, pair.y);
    vec4 impulse = old < 0 ? vec4(0) : texelFetch(lastColliderImpulses, old);
    if (surface.w < 0.5 * sim.diameter && impulse.w <= 0.0) impulse.w = ABOUT_TO_ACT;
    colliderImpulses[place] = impulse;
    colliderMeans[place] = old < 0 ? 0.0 : texelFetch(lastColliderMeans, old).x;
}
