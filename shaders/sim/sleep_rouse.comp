// One thread an assembly: wakes with its island, and then has all movers start from their contacts' impulses, as after
// a search.
#include "shared/kernel.glsl"
#include "shared/groups.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer islandsWoken;
BUFFER(uvec2, AssemblyCalm, assemblyCalm);
BUFFER(uvec4, Dispatches, dispatches);

void main()
{
    uint a = gl_GlobalInvocationID.x;
    if (a >= step.assemblyCount) return;
    uvec2 calm = assemblyCalm[a];
    if (calm.x < CALM_STEPS || texelFetch(islandsWoken, int(calm.y)).x == 0u) return;
    assemblyCalm[a] = uvec2(0u, a);
    dispatches[DISPATCH_MOVERS] = uvec4(groups(step.moverCount), 1, 1, 0);
}
