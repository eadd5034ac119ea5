// One thread converts the counts of all runs to the starts of each run's lists, and writes the draw arguments for
// solids and for fluids.
#include "render/spheres/sphere_runs.glsl"

layout(local_size_x = 1) in;
layout(std430) buffer SphereCounts { uvec4 counts[]; };
layout(std430) writeonly buffer SphereDraws { DrawArguments draws[]; };

void listGroup(uint group, uint firstRun, uint runs, uint first)
{
    uvec4 total = uvec4(0u);
    for (uint i = firstRun; i < firstRun + runs; ++i) {
        uvec4 count = counts[i];
        counts[i] = total;
        total += count;
    }
    uvec3 begin = first + uvec3(0u, 1u, 2u) * frame.particleCount;
    uint draw = DRAWS_PER_GROUP * group;
    draws[draw + POINT_DRAW] = DrawArguments(total.x, 1u, begin.x, 0u);
    draws[draw + QUAD_DRAW] = DrawArguments(QUAD_CORNERS * total.y, 1u, QUAD_CORNERS * begin.y, 0u);
    draws[draw + SHADOW_DRAW] = DrawArguments(total.z, 1u, begin.z, 0u);
}

void main()
{
    uint solidRuns = runCount(frame.solidCount);
    listGroup(SOLID_SPHERES, 0u, solidRuns, 0u);
    listGroup(FLUID_SPHERES, solidRuns, runCount(frame.particleCount - frame.solidCount), frame.solidCount);
}
