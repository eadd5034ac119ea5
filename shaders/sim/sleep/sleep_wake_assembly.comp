// One thread an assembly: wakes with its island, and then makes all movers start from their contacts' impulses, as
// after a search.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer islandsWoken;
BUFFER(Calm, AssemblyCalm, calms);
BUFFER(uvec4, Dispatches, dispatches);

void main()
{
    uint a = gl_GlobalInvocationID.x;
    if (a >= sim.assemblyCount) return;
    Calm calm = calms[a];
    if (!sleeps(calm) || texelFetch(islandsWoken, int(calm.island)).x == 0u) return;
#ifdef FREEZE
    calms[a].steps = 1u;   // it has not moved itself, so it wakes no other
#else
    calms[a] = Calm(0u, a);
#endif
    dispatches[DISPATCH_MOVERS] = uvec4(groups(sim.moverCount), 1, 1, 0);
}
