// One thread a particle: applies what is left of the last substep's impulses, and counts the contacts that are going
// to act, over which a body's mass is split (Tonge et al. 2012, mass splitting).
#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
#include "shared/contact_lists.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer predicted;
uniform samplerBuffer masses;
uniform usamplerBuffer candidates;
uniform usamplerBuffer candidateCounts;
BUFFER(vec4, Impulses, impulses);
BUFFER(vec4, Moved, moved);              // w: acting contacts
BUFFER(Counters, CountersBlock, counters);

vec3 warm(uint slot, vec3 normal)
{
    // Friction keeps all of it: what was lost would have to be won back by creeping.
    vec4 impulse = impulses[slot];
    impulse.w *= step.warmStart;
    impulse.xyz -= normal * dot(normal, impulse.xyz);
    impulses[slot] = impulse;
    return impulse.xyz + impulse.w * normal;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    vec3 move = texelFetch(predicted, int(i)).xyz;
    vec3 own = texelFetch(positions, int(i)).xyz;
    uint parity = counters[0].listParity;
    uvec2 count = texelFetch(candidateCounts, int(parity * step.particleCount + i)).xy;
    vec3 push = vec3(0);
    float acting = 0.0;
    for (uint s = 0u; s < count.x; ++s) {
        uint slot = contactSlot(parity, s, i);
        uint j = texelFetch(candidates, int(slot)).x;
        vec3 r = own - texelFetch(positions, int(j)).xyz + (move - texelFetch(predicted, int(j)).xyz);
        float far = length(r);
        bool before = impulses[slot].w > 0.0;
        push += warm(slot, contactNormal(r, far, i, j));
        acting += before || far < step.diameter ? 1.0 : 0.0;
    }
    for (uint s = 0u; s < count.y; ++s) {
        uint slot = colliderSlot(parity, s, i);
        vec4 surface = colliderDistance(texelFetch(candidates, int(slot)).x, own + move);
        bool before = impulses[slot].w > 0.0;
        push += warm(slot, surface.xyz);
        acting += before || surface.w < 0.5 * step.diameter ? 1.0 : 0.0;
    }
    moved[i] = vec4(move + texelFetch(masses, int(i)).x * push, acting);
}
