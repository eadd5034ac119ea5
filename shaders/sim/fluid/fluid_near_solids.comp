// One thread a solid particle: marks where fluids have it to list, and so to look further than among themselves. A bit
// stands for four cells in a row, which is about as far as solids are listed.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/fluid/near_solids.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSearchPositions;
BUFFER(uint, FluidNearSolids, fluidNearSolids);

void mark(uint cell)
{
    uvec2 place = nearSolidsBit(cell & gridMask());
    // Most of them are marked by another particle already.
    if ((fluidNearSolids[place.x] & place.y) == 0u) atomicOr(fluidNearSolids[place.x], place.y);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    ivec3 own = cellOf(texelFetch(fluidSearchPositions, int(i)).xyz);
    for (int row = 0; row < AROUND_RANGES; ++row) {
        uint cell = cellIndex(own + ivec3(0, row % 3 - 1, row / 3 - 1));
        mark(cell - uint(CELLS_ALONG));
        mark(cell);
        mark(cell + uint(CELLS_ALONG));
    }
}
