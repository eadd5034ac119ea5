// One thread a cell: empties it.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uint, CellCounts, cellCounts);

void main()
{
    uint cell = gl_GlobalInvocationID.x;
    if (cell <= gridMask()) cellCounts[cell] = 0u;
}
