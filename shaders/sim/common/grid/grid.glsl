// The neighbour grid: which cell a position is in, and the half of its neighbourhood in which a particle looks for
// others, so that each pair is found once: the particles after it in its own cell, and the cells that lie ahead.

ivec3 cellOf(vec3 x)
{
    return ivec3(floor(x * inverseGridCell()));
}

#ifdef GRID_HASH
#include "sim/common/grid/grid_hash.glsl"
#else
#include "sim/common/grid/grid_lattice.glsl"
#endif

// Ranges of cells: each has a first cell and an end, in the order of the sorted particles.

// Ranges ahead, which find each pair of particles once; range 0 begins with the own cell.
#define FORWARD_RANGES (RANGES_AROUND(3) - FORWARD_OFFSET)

bool inForwardRange(ivec3 c, int range, vec3 x)
{
    return inRangeAround(c, range + FORWARD_OFFSET, 3, x);
}

// All cells around.
#define AROUND_RANGES RANGES_AROUND(3)

uvec2 aroundCells(ivec3 c, int range)
{
    return cellsAround(c, range, 3);
}

// All cells up to two away.
#define FAR_RANGES RANGES_AROUND(5)

uvec2 farCells(ivec3 c, int range)
{
    return cellsAround(c, range, 5);
}

bool inFarRange(ivec3 c, int range, vec3 x)
{
    return inRangeAround(c, range, 5, x);
}
