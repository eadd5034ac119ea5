// One thread a cell: empties it.
#include "shared/kernel.glsl"
#include "shared/fluid_grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uint, CellCounts, cellCounts);

void main()
{
    uint cell = gl_GlobalInvocationID.x;
    if (cell <= gridMask()) cellCounts[cell] = 0u;
}
