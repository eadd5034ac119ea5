// The fluid around a point.
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"

uniform samplerBuffer foamFlows;
uniform usamplerBuffer cellStarts;

// How far fluid counts [rest distances], and the sum of its weights in the middle of fluid at rest: 4 pi times the
// integral of (1 - q^2)^2 q^2, times the cube of that.
const float AROUND = 1.4, AROUND_SUM = 0.9574 * AROUND * AROUND * AROUND;

struct FluidAround {
    float share;     // of what is around a point in the middle of fluid
    vec3 velocity;   // mean [m/s]
};

/// @param found  Where it was when cells were filled, in the middle of the step
FluidAround fluidAround(vec3 x, vec3 found)
{
    float reach = AROUND * sim.fluidSpacing, inverseSquare = 1.0 / (reach * reach);
    ivec3 low = cellOf(found - reach), high = cellOf(found + reach);
    uint slots = slotCount();
    vec4 sum = vec4(0);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y) {
            uint first = cellIndex(ivec3(low.x, y, z));
            uint n = texelFetch(cellStarts, int(first)).x;
            uint end = texelFetch(cellStarts, int(first + uint(high.x - low.x + 1))).x;
            for (; n < end; ++n) {
                // The first cells are listed again after the last.
                int k = int(n < slots ? n : n - slots);
                vec3 r = x - texelFetch(slotPositions, k).xyz;
                vec4 flow = texelFetch(foamFlows, k);
                float a = max(1.0 - dot(r, r) * inverseSquare, 0.0);
                sum += a * a * flow.w * vec4(flow.xyz, 1.0);
            }
        }
    return FluidAround(sum.w / AROUND_SUM, sum.xyz / max(sum.w, 1e-20));
}
