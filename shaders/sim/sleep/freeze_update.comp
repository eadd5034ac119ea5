// One thread an assembly: counts the steps in which its particles have stayed in place. It freezes after calmSteps.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(Calm, AssemblyCalm, calms);
BUFFER(Calm, AssemblyNext, assemblyNext);
BUFFER(uint, IslandsWoken, islandsWoken);
BUFFER(Assembly, AssemblyState, assemblies);

void main()
{
    uint a = gl_GlobalInvocationID.x;
    if (a >= sim.assemblyCount) return;
    Calm calm = calms[a];
    calm.steps = assemblyNext[a].steps == 0u ? 0u : min(calm.steps + 1u, sim.calmSteps);
    calms[a].steps = calm.steps;
    assemblyNext[a].steps = sim.calmSteps;
    islandsWoken[a] = 0u;
    if (sleeps(calm)) assemblies[a].order = 1u;   // for when it wakes
}
