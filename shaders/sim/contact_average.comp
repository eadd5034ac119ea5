// One thread a particle: one iteration of the paper's count-averaged Jacobi over its contacts and colliders (eqs. 3-7;
// Macklin et al. 2014, 4.2), on single particles.
#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
#include "shared/contact_lists.glsl"
#include "shared/averaged_contact.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;
uniform samplerBuffer positions;
uniform samplerBuffer masses;
uniform usamplerBuffer candidates;
uniform usamplerBuffer candidateCounts;
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

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    vec3 move = texelFetch(predicted, int(i)).xyz;
    vec3 start = texelFetch(positions, int(i)).xyz;
    vec4 mass = texelFetch(masses, int(i));
    uint parity = counters[0].listParity;
    uvec2 count = texelFetch(candidateCounts, int(parity * step.particleCount + i)).xy;
    vec3 push = vec3(0);
    float acting = 0.0;
    for (uint s = 0u; s < count.x; ++s) {
        uint j = texelFetch(candidates, int(contactSlot(parity, s, i))).x;
        vec3 startApart = start - texelFetch(positions, int(j)).xyz;
        vec3 slide = move - texelFetch(predicted, int(j)).xyz;
        vec3 r = startApart + CONTACT_MOVE(slide);
        float far = length(r);
        vec4 otherMass = texelFetch(masses, int(j));
        float both = mass.x + otherMass.x;
        if (far >= step.diameter || both == 0.0) continue;
        float error = CONTACT_ERROR(far - step.diameter, length(startApart) - step.diameter);
        push += averagedContact(contactNormal(r, far, i, j), error, mass.x / both, slide,
                                0.5 * (mass.zw + otherMass.zw));
        acting += 1.0;
    }
    for (uint s = 0u; s < count.y; ++s) {
        uint c = texelFetch(candidates, int(colliderSlot(parity, s, i))).x;
        vec4 surface = colliderDistance(c, start + CONTACT_MOVE(move));
        float gap = surface.w - 0.5 * step.diameter;
        if (gap >= 0.0 || mass.x == 0.0) continue;
        float error = CONTACT_ERROR(gap, colliderDistance(c, start).w - 0.5 * step.diameter);
        push += averagedContact(surface.xyz, error, 1.0, move, 0.5 * (mass.zw + colliders[c].friction.xy));
        acting += 1.0;
    }
    push /= max(acting, 1.0);
    if (acting > 0.0) assemblyState[texelFetch(particleInfo, int(i)).z].x = counters[0].substep - 1u;
#ifdef STABILIZE
    stabilized[i] = vec4(start + push, 0);
#else
    moved[i] = vec4(move + push, acting);
#endif
}
