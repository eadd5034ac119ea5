// One thread a slot: how its fluid particle's surroundings swirl (Macklin and Mueller 2013, eq. 15).
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPositions;
uniform samplerBuffer slotVelocities;
BUFFER(vec4, SlotVorticities, slotVorticities);   // w: length

vec3 swirlBy(vec3 place, vec3 velocity, uint slot)
{
    vec3 r = place - texelFetch(slotPositions, int(slot)).xyz;
    float q = min(length(r) / sim.fluidReach, 1.0);
    return fluidSlope(q) * cross(r, texelFetch(slotVelocities, int(slot)).xyz - velocity);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint count = isFluid(texelFetch(slotParticles, int(k)).x) ? texelFetch(slotCounts, int(k)).x : 0u;
    vec3 place = texelFetch(slotPositions, int(k)).xyz, velocity = texelFetch(slotVelocities, int(k)).xyz, swirl = vec3(0);
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = neighboursAt(texel);
        for (int c = 0; c < 4; ++c) swirl += swirlBy(place, velocity, slots[c]);
    }
    slotVorticities[k] = vec4(swirl, length(swirl));
}
