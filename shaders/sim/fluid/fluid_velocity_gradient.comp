// One thread a slot: how velocities change with place around its fluid particle, by differences to its neighbours and
// the inverse of their moments (Randles and Libersky 1996). fluid_viscosity takes that much from what it smooths.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/neighbour_moments.glsl"

layout(local_size_x = GROUP_SIZE) in;
UINT_TEXELS(newSlotGradients)

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint count = fetchFluidCounts(k, fetchSlotParticle(k)).fluids;
    vec3 x = fetchSlotPosition(k).position;
    SlotVelocity own = fetchSlotVelocity(k);
    Moments sums = noMoments(count);
    mat3 slopes = mat3(0);
    float inverseReach = 1.0 / sim.fluidReach;
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) {
            vec3 slope = addMoment(sums, x - fetchSlotPosition(slots[c]).position, inverseReach);
            slopes += outerProduct(own.velocity - fetchSlotVelocity(slots[c]).velocity, slope);
        }
    } while (nextTexel(texels));
    // Where neighbours lack, velocities are taken to change less.
    float lacking = 0.1 * max(1.0 - sim.fluidVolume * sums.fraction, 0.0) + 0.005;
    mat3 moment = momentMatrix(sums) + mat3(lacking);
    SlotGradient gradient = SlotGradient(evenSmoothing(own) * -fluidSteepness() * slopes * inverse(moment));
    imageStore(newSlotGradients, int(k), pack(gradient));
}
