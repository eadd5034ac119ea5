// One thread an assembly: for how many steps all its particles have stayed where they are. It freezes after calmSteps.
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uvec2, AssemblyCalm, assemblyCalm);
BUFFER(uvec2, AssemblyNext, assemblyNext);
BUFFER(uint, IslandsWoken, islandsWoken);

void main()
{
    uint a = gl_GlobalInvocationID.x;
    if (a >= sim.assemblyCount) return;
    assemblyCalm[a].x = assemblyNext[a].x == 0u ? 0u : min(assemblyCalm[a].x + 1u, sim.calmSteps);
    assemblyNext[a].x = sim.calmSteps;
    islandsWoken[a] = 0u;
}
