// One thread a slot: viscosity, as velocities that even out (Macklin and Mueller 2013, eq. 17, XSPH). The strength is
// that of the fluid's viscosity: a step of c = 6 nu t / <r^2> spreads momentum as nu does in the time t, <r^2> being
// the kernel's mean.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPositions;
uniform samplerBuffer slotVelocities;    // w: smoothing
BUFFER(vec4, Velocities, velocities);

/// What the neighbour in a slot gives to the velocity. Of two masses the lighter takes more, so that momentum is kept.
vec3 changeBy(vec4 place, vec4 velocity, uint slot)
{
    vec4 other = texelFetch(slotVelocities, int(slot)), there = texelFetch(slotPositions, int(slot));
    float q = min(distance(place.xyz, there.xyz) / sim.fluidReach, 1.0);
    float share = there.w / (place.w + there.w) * fluidFraction(q);
    return (velocity.w + other.w) * share * (other.xyz - velocity.xyz);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    bool fluid = isFluid(i);
    uint count = fluid ? texelFetch(slotCounts, int(k)).x : 0u;
    vec4 place = texelFetch(slotPositions, int(k));
    vec3 change = vec3(0);
    vec4 own = texelFetch(slotVelocities, int(k));
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = neighboursAt(texel);
        change += changeBy(place, own, slots.x);
        change += changeBy(place, own, slots.y);
        change += changeBy(place, own, slots.z);
        change += changeBy(place, own, slots.w);
    }
    if (fluid && timeHeld(velocities[i]) == 0.0) velocities[i].xyz += change;
}
