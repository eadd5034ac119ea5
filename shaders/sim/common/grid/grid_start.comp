// One thread a chunk of cells: where each cell's particles start in the sorted arrays. The first cells are listed again
// after the last (see sim/common/grid/grid.glsl).
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/scan.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellCounts;
uniform usamplerBuffer cellSums;
BUFFER(uint, CellStarts, cellStarts);

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if (chunk >= chunkCount()) return;
    uint sum = texelFetch(cellSums, int(chunk)).x;
    for (uint k = 0u; k < SCAN_CHUNK; ++k) {
        uint cell = chunk * SCAN_CHUNK + k;
        cellStarts[cell] = sum;
        sum += texelFetch(cellCounts, int(cell)).x;
    }
    if (chunk == 0u) {
        uint cells = gridMask() + 1u, end = gridMembers();
        for (uint cell = 0u; cell <= WRAPPED_CELLS; ++cell) {
            cellStarts[cells + cell] = end;
            end += texelFetch(cellCounts, int(cell)).x;
        }
    }
}
