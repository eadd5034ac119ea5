// One thread a particle: one iteration of count-averaged Jacobi over its contacts (eqs. 3-7; Macklin et al. 2014, 4.2).
// The match of a body averages over all its particles once more, which over-relaxation makes up for. STABILIZE: how far
// it is to be moved out of the overlaps that it starts in (their 4.4).
#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
#include "shared/list_ranges.glsl"
#include "shared/averaged_contact.glsl"
#include "shared/mass_scaling.glsl"
#include "shared/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;
uniform samplerBuffer positions;
uniform samplerBuffer masses;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform usamplerBuffer pairReferences;
uniform usamplerBuffer colliderSides;
uniform usamplerBuffer particlePlaces;   // mover, rank
uniform usamplerBuffer particleInfo;
BUFFER(uvec2, AssemblyState, assemblyState);
BUFFER(vec4, Moved, moved);
READ_BUFFER(Counters, CountersBlock, counters);

Side sideOf(uint i)
{
    vec3 start = texelFetch(positions, int(i)).xyz;
    bool held = isAsleep(texelFetch(particleInfo, int(i)).z);
    float inverseMass = held ? 0.0 : contactScale(start) * texelFetch(masses, int(i)).x;
    return Side(start, texelFetch(predicted, int(i)).xyz, inverseMass);
}

Push colliderPush(Side own, uvec4 sides)
{
    vec4 surface = colliderDistance(sides.y, own.start + own.move);
    float startGap = colliderDistance(sides.y, own.start).w - 0.5 * step.diameter;
    return contactPush(surface.xyz, surface.w - 0.5 * step.diameter, startGap, own.move, own.inverseMass,
                       unpackHalf2x16(sides.z));
}

void add(inout Push sum, Push other, float side)
{
    sum.impulse += side * other.impulse;
    sum.acting += other.acting;
}

/// The sums over the three lists of a particle.
Push allPushes(Side own, uint parity, uint rank)
{
    Push sum = Push(vec3(0), 0.0);
    uint base = parity * step.pairCapacity;
    uvec2 range = listRange(parity, FIRST_OF_PAIR, rank, 1u);
    for (uint q = range.x; q < range.y; ++q)
        add(sum, pairPush(own, sideOf(texelFetch(pairs, int(base + q)).y), texelFetch(pairSides, int(q))), 1.0);
    range = listRange(parity, SECOND_OF_PAIR, rank, 1u);
    for (uint k = range.x; k < range.y; ++k) {
        uint q = texelFetch(pairReferences, int(k)).x;
        if (q == NO_PAIR) continue;
        add(sum, pairPush(sideOf(texelFetch(pairs, int(base + q)).x), own, texelFetch(pairSides, int(q))), -1.0);
    }
    range = listRange(parity, WITH_COLLIDER, rank, 1u);
    for (uint q = range.x; q < range.y; ++q) add(sum, colliderPush(own, texelFetch(colliderSides, int(q))), 1.0);
    return sum;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    uvec4 info = texelFetch(particleInfo, int(i));
    Side own = sideOf(i);
    Push sum = allPushes(own, counters[0].listParity, texelFetch(particlePlaces, int(i)).y);
    float relaxation = (info.y > 0u ? step.overRelaxation : 1.0) / max(sum.acting, 1.0);
    vec3 push = relaxation * own.inverseMass * sum.impulse;
    if (sum.acting > 0.0) assemblyState[info.z].x = counters[0].substep - 1u;
#ifdef STABILIZE
    moved[i] = vec4(push, 0);
#else
    moved[i] = vec4(own.move + push, 0);
#endif
}
