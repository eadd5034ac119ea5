// One thread an assembly: wakes with its island, and then has all movers start from their contacts' impulses, as after
// a search.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer islandsWoken;
BUFFER(uvec2, AssemblyCalm, assemblyCalm);
BUFFER(uvec4, Dispatches, dispatches);

void main()
{
    uint a = gl_GlobalInvocationID.x;
    if (a >= sim.assemblyCount) return;
    uvec2 calm = assemblyCalm[a];
    if (calm.x < sim.calmSteps || texelFetch(islandsWoken, int(calm.y)).x == 0u) return;
#ifdef FREEZE
    assemblyCalm[a].x = 1u;   // it has not moved itself, and wakes nobody
#else
    assemblyCalm[a] = uvec2(0u, a);
#endif
    dispatches[DISPATCH_MOVERS] = uvec4(groups(sim.moverCount), 1, 1, 0);
}
