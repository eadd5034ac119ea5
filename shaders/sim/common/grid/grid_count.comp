// One thread a particle: counts it in its cell.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchPositions;
BUFFER(uint, CellCounts, cellCounts);
BUFFER(uvec2, ParticleCells, particleCells);   // cell, arrival in it

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= gridParticles()) return;
    vec4 found = texelFetch(searchPositions, int(i));
    if (isInactive(found)) {
        particleCells[i] = uvec2(NONE, 0);
        return;
    }
    uint cell = cellIndex(cellOf(found.xyz));
    particleCells[i] = uvec2(cell, atomicAdd(cellCounts[cell], 1u));
}
