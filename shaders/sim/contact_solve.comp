// One thread a particle: one Jacobi iteration over its contacts as accumulated impulses. Both sides of a contact
// compute the same impulse from the same numbers, so momentum is kept without anything being scattered. The impulse
// is carried as a displacement of the particle alone; shape matching spreads it over the body.
#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
#include "shared/contact_lists.glsl"
#include "shared/contact_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;         // move; w: effective inverse mass, split over the body's contacts
uniform samplerBuffer positions;
uniform samplerBuffer masses;
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer candidates;
uniform usamplerBuffer candidateCounts;
BUFFER(vec4, Impulses, impulses);
BUFFER(vec4, Moved, moved);
BUFFER(uvec2, AssemblyState, assemblyState);
BUFFER(Counters, CountersBlock, counters);

/// @returns the change of the impulse in xyz, 1 in w where the contact acts.
vec4 apply(uint slot, Contact contact)
{
    float growthMass = contact.inverseMass > 0.0 ? 1.0 / contact.inverseMass : 0.0;
    vec4 before = impulses[slot];
    vec4 after = solveContact(contact, before);
    vec3 change = after.xyz - before.xyz + (after.w - before.w) * contact.normal;
    // A shock must not be replayed by the next substep's warm start.
    float kept = min(after.w, 2.0 * before.w + growthMass * step.impulseGrowth);
    impulses[slot] = after.w > 0.0 ? vec4(after.xyz * (kept / after.w), kept) : vec4(0);
    return vec4(change, after.w > 0.0 || contact.gap < 0.0 ? 1.0 : 0.0);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    vec4 own = texelFetch(predicted, int(i));
    uint parity = counters[0].listParity;
    uvec2 count = texelFetch(candidateCounts, int(parity * step.particleCount + i)).xy;
    vec4 mass = texelFetch(masses, int(i));
    vec3 start = texelFetch(positions, int(i)).xyz;
    vec4 change = vec4(0);
    Contact contact;
    for (uint s = 0u; s < count.x; ++s) {
        uint slot = contactSlot(parity, s, i);
        uint j = texelFetch(candidates, int(slot)).x;
        vec4 other = texelFetch(predicted, int(j));
        vec3 startApart = start - texelFetch(positions, int(j)).xyz;
        contact.slide = own.xyz - other.xyz;
        vec3 r = startApart + contact.slide;
        float far = length(r);
        contact.normal = contactNormal(r, far, i, j);
        contact.gap = far - step.diameter;
        contact.startGap = length(startApart) - step.diameter;
        contact.inverseMass = own.w + other.w;
        contact.friction = 0.5 * (mass.zw + texelFetch(masses, int(j)).zw);
        change += apply(slot, contact);
    }
    for (uint s = 0u; s < count.y; ++s) {
        uint slot = colliderSlot(parity, s, i);
        uint c = texelFetch(candidates, int(slot)).x;
        vec4 surface = colliderDistance(c, start + own.xyz);
        contact.normal = surface.xyz;
        contact.gap = surface.w - 0.5 * step.diameter;
        contact.startGap = colliderDistance(c, start).w - 0.5 * step.diameter;
        contact.slide = own.xyz;
        contact.inverseMass = own.w;
        contact.friction = 0.5 * (mass.zw + colliders[c].friction.xy);
        change += apply(slot, contact);
    }
    if (change.xyz != vec3(0)) assemblyState[texelFetch(particleInfo, int(i)).z].x = counters[0].substep - 1u;
    moved[i] = vec4(own.xyz + mass.x * change.xyz, change.w);
}
