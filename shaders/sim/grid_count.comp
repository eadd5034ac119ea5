// One thread a particle: counts it in its cell, and notes where it stood when candidates were found.
#include "shared/kernel.glsl"
#include "shared/grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer predicted;
BUFFER(uint, CellCounts, cellCounts);
BUFFER(uvec2, ParticleCells, particleCells);   // cell, arrival in it
BUFFER(vec4, FoundPositions, foundPositions);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    vec4 x = texelFetch(positions, int(i)) + texelFetch(predicted, int(i));
    foundPositions[i] = x;
    uint cell = cellIndex(cellOf(x.xyz));
    particleCells[i] = uvec2(cell, atomicAdd(cellCounts[cell], 1u));
}
