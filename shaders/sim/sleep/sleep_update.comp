// One thread an assembly: takes over what sleep_mover and sleep_island found. An assembly that has moved lately is an
// island of its own.
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
    Calm next = assemblyNext[a];
    uint steps = min(next.steps, sim.calmSteps);
    Calm calm = Calm(steps, steps < sim.calmSteps / 2u ? a : min(next.island, a));
    calms[a] = calm;
    assemblyNext[a] = Calm(sim.calmSteps, a);
    islandsWoken[a] = 0u;
    if (sleeps(calm)) assemblies[a].order = 1u;   // for when it wakes
}
