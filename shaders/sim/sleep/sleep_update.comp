// One thread an assembly: takes over what sleep_mover and sleep_island found. One that has moved lately has its own name.
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uvec2, AssemblyCalm, assemblyCalm);
BUFFER(uvec2, AssemblyNext, assemblyNext);
BUFFER(uint, IslandsWoken, islandsWoken);

void main()
{
    uint a = gl_GlobalInvocationID.x;
    if (a >= sim.assemblyCount) return;
    uvec2 next = assemblyNext[a];
    uint calm = min(next.x, sim.calmSteps);
    assemblyCalm[a] = uvec2(calm, calm < sim.calmSteps / 2u ? a : min(next.y, a));
    assemblyNext[a] = uvec2(sim.calmSteps, a);
    islandsWoken[a] = 0u;
}
