// One thread a particle: one iteration of the paper's count-averaged Jacobi over its contacts and colliders (eqs. 3-7;
// Macklin et al. 2014, 4.2), on single particles.
#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
#include "shared/list_ranges.glsl"
#include "shared/averaged_contact.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;
uniform samplerBuffer positions;
uniform samplerBuffer masses;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairReferences;
uniform usamplerBuffer colliderSides;
uniform usamplerBuffer particlePlaces;   // mover, rank
uniform usamplerBuffer particleInfo;
BUFFER(uvec2, AssemblyState, assemblyState);
BUFFER(Counters, CountersBlock, counters);

#ifdef STABILIZE
BUFFER(vec4, Stabilized, stabilized);
#define CONTACT_MOVE(move) vec3(0)
#define CONTACT_ERROR(gap, startGap) (gap)
#else
BUFFER(vec4, Moved, moved);
#define CONTACT_MOVE(move) (move)
#define CONTACT_ERROR(gap, startGap) contactError(gap, startGap)
#endif

/// What a particle's contacts ask of it.
struct Wish {
    vec3 push;
    float acting;
};

void addParticle(inout Wish wish, uint i, uint j, vec3 start, vec3 move, vec4 mass)
{
    vec3 startApart = start - texelFetch(positions, int(j)).xyz;
    vec3 slide = move - texelFetch(predicted, int(j)).xyz;
    vec3 r = startApart + CONTACT_MOVE(slide);
    float far = length(r);
    vec4 otherMass = texelFetch(masses, int(j));
    float both = mass.x + otherMass.x;
    if (far >= step.diameter || both == 0.0) return;
    float error = CONTACT_ERROR(far - step.diameter, length(startApart) - step.diameter);
    wish.push += averagedContact(contactNormal(r, far, i < j), error, mass.x / both, slide,
                                 0.5 * (mass.zw + otherMass.zw));
    wish.acting += 1.0;
}

void addCollider(inout Wish wish, uvec4 sides, vec3 start, vec3 move, float inverseMass)
{
    vec4 surface = colliderDistance(sides.y, start + CONTACT_MOVE(move));
    float gap = surface.w - 0.5 * step.diameter;
    if (gap >= 0.0 || inverseMass == 0.0) return;
    float error = CONTACT_ERROR(gap, colliderDistance(sides.y, start).w - 0.5 * step.diameter);
    wish.push += averagedContact(surface.xyz, error, 1.0, move, unpackHalf2x16(sides.z));
    wish.acting += 1.0;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    vec3 move = texelFetch(predicted, int(i)).xyz;
    vec3 start = texelFetch(positions, int(i)).xyz;
    vec4 mass = texelFetch(masses, int(i));
    uint parity = counters[0].listParity, rank = texelFetch(particlePlaces, int(i)).y;
    Wish wish = Wish(vec3(0), 0.0);
    uvec2 range = listRange(parity, FIRST_OF_PAIR, rank, 1u) + parity * step.pairCapacity;
    for (uint q = range.x; q < range.y; ++q)
        addParticle(wish, i, texelFetch(pairs, int(q)).y, start, move, mass);
    range = listRange(parity, SECOND_OF_PAIR, rank, 1u);
    for (uint k = range.x; k < range.y; ++k) {
        uint reference = texelFetch(pairReferences, int(k)).x;
        if (reference == NO_PAIR) continue;
        uint q = parity * step.pairCapacity + reference;
        addParticle(wish, i, texelFetch(pairs, int(q)).x, start, move, mass);
    }
    range = listRange(parity, WITH_COLLIDER, rank, 1u);
    for (uint q = range.x; q < range.y; ++q)
        addCollider(wish, texelFetch(colliderSides, int(q)), start, move, mass.x);
    wish.push /= max(wish.acting, 1.0);
    if (wish.acting > 0.0) assemblyState[texelFetch(particleInfo, int(i)).z].x = counters[0].substep - 1u;
#ifdef STABILIZE
    stabilized[i] = vec4(start + wish.push, 0);
#else
    moved[i] = vec4(move + wish.push, 0);
#endif
}
