// One thread a slot: vorticity confinement (Macklin and Mueller 2013, eq. 16): drives its fluid particle around where
// the swirl is strongest. The strength has no unit: the acceleration is e s |w| (N x w), s being the rest distance.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPositions;
uniform samplerBuffer slotVorticities;   // w: length
BUFFER(vec4, Velocities, velocities);

vec3 riseBy(vec3 place, float swirl, uint slot)
{
    vec3 r = place - texelFetch(slotPositions, int(slot)).xyz;
    float q = min(length(r) / sim.fluidReach, 1.0);
    return (texelFetch(slotVorticities, int(slot)).w - swirl) * fluidSlope(q) * r;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x, count = isFluid(i) ? texelFetch(slotCounts, int(k)).x : 0u;
    vec3 place = texelFetch(slotPositions, int(k)).xyz, rise = vec3(0);
    vec4 swirl = texelFetch(slotVorticities, int(k));
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = neighboursAt(texel);
        for (int c = 0; c < 4; ++c) rise += riseBy(place, swirl.w, slots[c]);
    }
    if (count == 0u || timeHeld(velocities[i]) > 0.0) return;
    // Where the swirl is the same all around there is no middle to drive it about.
    vec3 towards = rise / (length(rise) + 0.01 * swirl.w / sim.fluidSpacing + 1e-6);
    // At most a tenth of what it differs by from its neighbours.
    float turn = min(sim.vorticity * swirl.w, 0.1);
    velocities[i].xyz += turn * sim.fluidSpacing * cross(towards, swirl.xyz);
}
