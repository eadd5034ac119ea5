// One thread a particle: its id into its cell, in the order of arrival (which differs from run to run).
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer particleCells;
BUFFER(uint, CellMembers, cellMembers);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= gridParticles()) return;
    uvec2 found = texelFetch(particleCells, int(i)).xy;
    uint cell = found.x, arrival = found.y;
    if (isNowhere(cell)) return;
    cellMembers[texelFetch(cellStarts, int(cell)).x + arrival] = i;
}
