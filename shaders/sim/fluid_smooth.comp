// One thread a slot: viscosity, as velocities that even out (Macklin and Mueller 2013, eq. 17, XSPH). The strength is that
// of the fluid's viscosity: a step of c = 6 nu t / <r^2> spreads momentum as nu does in the time t, <r^2> the kernel's mean.
#include "shared/kernel.glsl"
#include "shared/fluid_slots.glsl"
#include "shared/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPlaces;
uniform samplerBuffer slotVelocities;    // w: smoothing
BUFFER(vec4, Velocities, velocities);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    bool fluid = isFluid(i);
    uint count = fluid ? texelFetch(slotCounts, int(k)).x : 0u;
    vec3 x = texelFetch(slotPlaces, int(k)).xyz, change = vec3(0);
    vec4 own = texelFetch(slotVelocities, int(k));
    for (uint n = 0u; n < count; ++n) {
        uint slot = fluidNeighbour(k, n);
        vec4 other = texelFetch(slotVelocities, int(slot));
        float q = min(length(x - texelFetch(slotPlaces, int(slot)).xyz) / step.fluidReach, 1.0);
        change += 0.5 * (own.w + other.w) * fluidShare(q) * (other.xyz - own.xyz);
    }
    if (fluid) velocities[i].xyz += change;
}
