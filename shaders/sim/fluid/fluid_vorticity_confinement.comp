// One thread a slot: vorticity confinement (Macklin and Mueller 2013, eq. 16): drives its fluid particle around where
// the vorticity w is strongest. The strength e has no unit: the acceleration is e s |w| (N x w), s being the rest
// distance and N the direction towards there.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, Velocities, velocities);

/// A neighbour's part of the gradient of the vorticity's size.
vec3 gradientBy(vec3 x, float size, uint slot)
{
    vec3 r = x - fetchSlotPosition(slot).position;
    float q = min(length(r) / sim.fluidReach, 1.0);
    return (fetchSlotVorticity(slot).size - size) * fluidSlope(q) * r;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k), count = fetchFluidCounts(k, i).fluids;
    vec3 x = fetchSlotPosition(k).position, gradient = vec3(0);
    SlotVorticity own = fetchSlotVorticity(k);
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) gradient += gradientBy(x, own.size, slots[c]);
    } while (nextTexel(texels));
    if (count == 0u || fluidVelocity(velocities[i]).timeHeld > 0.0) return;
    // If the vorticity is the same all around, there is no centre of rotation.
    vec3 towards = gradient / (length(gradient) + 0.01 * own.size / sim.fluidSpacing + 1e-6);
    // At most a tenth of its difference to its neighbours.
    float strength = min(sim.vorticity * own.size, 0.1);
    velocities[i].xyz += strength * sim.fluidSpacing * cross(towards, own.vorticity);
}
