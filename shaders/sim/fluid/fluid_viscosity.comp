// One thread a slot: viscosity, as smoothing of velocities (Macklin and Mueller 2013, eq. 17, XSPH). The strength
// follows from the fluid's viscosity: c = 6 nu t / <r^2> spreads momentum in the time t as the kinematic viscosity nu
// does, <r^2> being the kernel's mean. What differs from an even change of velocity is smoothed more, to quiet fluids
// at rest; where it is larger than such noise it is flow, and is let be.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, Velocities, velocities);

/// The change of velocity by the neighbour in a slot. Of two masses the lighter changes more, so that momentum is kept.
vec3 changeBy(SlotPosition at, SlotVelocity own, mat3 slope, uint slot)
{
    SlotVelocity other = fetchSlotVelocity(slot);
    SlotPosition there = fetchSlotPosition(slot);
    vec3 r = there.position - at.position;
    float q = min(length(r) / sim.fluidReach, 1.0);
    float fraction = there.mass / (at.mass + there.mass) * fluidFraction(q);
    vec3 apart = other.velocity - own.velocity;
    float even = evenSmoothing(own) + evenSmoothing(other), quiet = max(even * sim.quietSpeed, 1e-12);
    vec3 uneven = even * apart - (slope + fetchSlotGradient(slot).slope) * r;
    uneven /= 1.0 + dot(uneven, uneven) / (quiet * quiet);
    return fraction * ((max(own.smoothing, 0.0) + max(other.smoothing, 0.0)) * apart + uneven);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k), count = fetchFluidCounts(k, i).fluids;
    SlotPosition at = fetchSlotPosition(k);
    SlotVelocity own = fetchSlotVelocity(k);
    mat3 slope = fetchSlotGradient(k).slope;
    vec3 change = vec3(0);
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        change += changeBy(at, own, slope, slots.x);
        change += changeBy(at, own, slope, slots.y);
        change += changeBy(at, own, slope, slots.z);
        change += changeBy(at, own, slope, slots.w);
    } while (nextTexel(texels));
    if (isFluid(i) && fluidVelocity(velocities[i]).timeHeld == 0.0) velocities[i].xyz += change;
}
