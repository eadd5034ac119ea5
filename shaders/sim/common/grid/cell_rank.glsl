// A particle's place in the arrays that are sorted by cells, and each cell by particle id.
#include "sim/common/grid/fluid_grid.glsl"

uniform usamplerBuffer cellStarts;
uniform usamplerBuffer cellMembers;
uniform usamplerBuffer particleCells;

/// The place, and the second place of a particle whose cell is one of the first (sim/common/grid/grid.glsl), else NONE.
uvec2 placeInCells(uint particle)
{
    uint cell = texelFetch(particleCells, int(particle)).x;
    uint start = texelFetch(cellStarts, int(cell)).x;
    uint count = texelFetch(cellStarts, int(cell + 1u)).x - start;
    uint rank = 0u;
    for (uint k = 0u; k < count; ++k) rank += texelFetch(cellMembers, int(start + k)).x < particle ? 1u : 0u;
    uint again = cell < WRAPPED_CELLS ? texelFetch(cellStarts, int(gridMask() + 1u + cell)).x + rank : NONE;
    return uvec2(start + rank, again);
}
