// One thread a slot: its particle's velocity at the end of the step, and which way the fluid ends, if it does nearby.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer velocities;
BUFFER(vec4, FoamFlows, newFoamFlows);
BUFFER(vec4, FoamFacings, newFoamFacings);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k), count = fetchFluidCounts(k, i).fluids;
    vec3 x = fetchSlotPosition(k).position, sum = vec3(0);
    float inverseReach = 1.0 / sim.fluidReach, most = 0.0;
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) {
            vec3 r = x - fetchSlotPosition(slots[c]).position;
            float apart = length(r), a = max(1.0 - apart * inverseReach, 0.0);
            sum += a * r;
            most += a * apart;
        }
    } while (nextTexel(texels));
    // In the middle of fluid neighbours are on all sides; the share of them that is not is about a half at its surface.
    float size = length(sum);
    newFoamFlows[k] = vec4(texelFetch(velocities, int(i)).xyz, isFluid(i) ? 1.0 : 0.0);
    newFoamFacings[k] = vec4(sum / max(size, 1e-20), size / max(most, 1e-20));
}
