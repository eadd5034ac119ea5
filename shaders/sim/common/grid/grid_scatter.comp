// One thread a particle: puts its id into its cell, in the order of arrival (which differs from run to run). The
// threads together clear the counts of the cells for the next search.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer particleCells;
BUFFER(uint, CellMembers, cellMembers);
BUFFER(uint, CellCounts, cellCounts);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= gridParticles()) return;
    for (uint cell = i; cell <= gridMask(); cell += gridParticles()) cellCounts[cell] = 0u;
    uvec2 found = texelFetch(particleCells, int(i)).xy;
    uint cell = found.x, arrival = found.y;
    if (isNowhere(cell)) return;
    cellMembers[texelFetch(cellStarts, int(cell)).x + arrival] = i;
}
