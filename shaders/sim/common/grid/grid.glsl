// The neighbour grid: which cell a position is in, and the half of its neighbourhood in which a particle looks for
// others, so that each pair is found once: what follows it in its own cell, and the cells that lie ahead.

ivec3 cellOf(vec3 x)
{
    return ivec3(floor(x * inverseGridCell()));
}

#ifdef GRID_HASH

// Teschner et al. 2003: h = (73856093 x xor 19349663 y xor 83492791 z) mod n, on unsigned values.
#define RANGES_AROUND(width) (width * width * width)
#define FORWARD_OFFSET 13

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    return (73856093u * u.x ^ 19349663u * u.y ^ 83492791u * u.z) & gridMask();
}

/// Of the cube of width^3 cells around c.
ivec3 cellAround(ivec3 c, int range, int width)
{
    return c + ivec3(range % width, range / width % width, range / (width * width)) - width / 2;
}

uvec2 cellsAround(ivec3 c, int range, int width)
{
    uint first = cellIndex(cellAround(c, range, width));
    return uvec2(first, first + 1u);
}

// Two of the cells may share a bucket: only what lies in the cell asked for counts.
bool inRangeAround(ivec3 c, int range, int width, vec3 x)
{
    return cellOf(x) == cellAround(c, range, width);
}

uvec2 forwardCells(ivec3 c, int range)
{
    return cellsAround(c, range + FORWARD_OFFSET, 3);
}

#else

// A lattice wrapped onto a line. Neighbours in x are neighbours on the line, so three cells are one range, or three
// times CELLS_ALONG; the first WRAPPED_CELLS cells stand again behind the last, so that a range never wraps.
#define RANGES_AROUND(width) (width * width)
#define FORWARD_OFFSET 4

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    uvec2 strides = gridStrides();
    return (u.x + strides.x * u.y + strides.y * u.z) & gridMask();
}

/// Of the rows along x around c that reach as far as `width` cells.
uvec2 cellsAround(ivec3 c, int range, int width)
{
    int ahead = width / 2 * CELLS_ALONG;
    uint first = cellIndex(c + ivec3(-ahead, range % width - width / 2, range / width - width / 2));
    return uvec2(first, first + uint(2 * ahead + 1));
}

bool inRangeAround(ivec3 c, int range, int width, vec3 x)
{
    return true;
}

uvec2 forwardCells(ivec3 c, int range)
{
    uint own = cellIndex(c);
    return range == 0 ? uvec2(own, own + 2u) : cellsAround(c, range + FORWARD_OFFSET, 3);
}

#endif

// Ranges of cells: each has a first cell and the one behind its last, in the order of the sorted particles.

// Ahead, each pair of particles in one of the two directions; range 0 begins with the own cell.
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
