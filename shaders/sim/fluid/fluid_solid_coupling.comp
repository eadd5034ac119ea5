// One thread a solid particle: what the fluid around presses it with, against what fluid_pressure gives to the fluid.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPositions;
uniform samplerBuffer slotPressures;     // place, lambda
uniform samplerBuffer slotSolids;        // gradient; w: one over the weights of all solid particles there
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer particleSlots;
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(uvec2, AssemblyState, assemblyState);   // last substep with a contact
READ_BUFFER(Counters, CountersBlock, counters);

/// The impulse of the fluid particle in a slot on a solid one at x.
vec3 impulseOf(vec3 x, uint slot)
{
    vec4 fluid = texelFetch(slotPressures, int(slot)), solid = texelFetch(slotSolids, int(slot));
    return -solidWeight(distance(fluid.xyz, x)) * solid.w * fluid.w * solid.xyz;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uint k = texelFetch(particleSlots, int(i)).x, count = texelFetch(slotCounts, int(k)).x;
    vec3 x = texelFetch(slotPositions, int(k)).xyz, impulse = vec3(0);
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = neighboursAt(texel);
        impulse += impulseOf(x, slots.x) + impulseOf(x, slots.y) + impulseOf(x, slots.z) + impulseOf(x, slots.w);
    }
    if (impulse == vec3(0)) return;
    // As contacts do: its assembly ends the substep to first order.
    assemblyState[texelFetch(particleInfo, int(i)).z].x = counters[0].substep - 1u;
    particleImpulses[texelFetch(particleRanks, int(i)).y].xyz += impulse;
}
