// One thread a slot: the vorticity around its fluid particle (Macklin and Mueller 2013, eq. 15).
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, SlotVorticities, newSlotVorticities);

vec3 vorticityBy(vec3 x, vec3 velocity, uint slot)
{
    vec3 r = x - fetchSlotPosition(slot).position;
    float q = min(length(r) / sim.fluidReach, 1.0);
    return fluidSlope(q) * cross(r, fetchSlotVelocity(slot).velocity - velocity);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint count = fetchFluidCounts(k, fetchSlotParticle(k)).fluids;
    vec3 x = fetchSlotPosition(k).position, velocity = fetchSlotVelocity(k).velocity, vorticity = vec3(0);
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) vorticity += vorticityBy(x, velocity, slots[c]);
    } while (nextTexel(texels));
    newSlotVorticities[k] = pack(SlotVorticity(vorticity, length(vorticity)));
}
