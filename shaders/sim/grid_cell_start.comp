// One thread a chunk of cells: where each cell's particles start in the sorted arrays. The first two cells are listed
// once more behind the last (see shared/grid.glsl).
#include "shared/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellCounts;
uniform usamplerBuffer chunkSums;
BUFFER(uint, CellStarts, cellStarts);

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if (chunk * CELLS_PER_CHUNK > step.cellMask) return;
    uint sum = texelFetch(chunkSums, int(chunk)).x;
    for (uint k = 0u; k < CELLS_PER_CHUNK; ++k) {
        uint cell = chunk * CELLS_PER_CHUNK + k;
        cellStarts[cell] = sum;
        sum += texelFetch(cellCounts, int(cell)).x;
    }
    if (chunk == 0u) {
        uint cells = step.cellMask + 1u;
        uint first = texelFetch(cellCounts, 0).x;
        cellStarts[cells] = step.particleCount;
        cellStarts[cells + 1u] = step.particleCount + first;
        cellStarts[cells + 2u] = step.particleCount + first + texelFetch(cellCounts, 1).x;
    }
}
