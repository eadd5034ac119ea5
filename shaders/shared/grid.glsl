// The neighbour grid: which cell a position is in, and the half of its neighbourhood in which a particle looks for
// others, so that each pair is found once: what follows it in its own cell, and the cells that lie ahead.

ivec3 cellOf(vec3 x)
{
    return ivec3(floor(x * inverseGridCell()));
}

#ifdef GRID_HASH

// Teschner et al. 2003: h = (73856093 x xor 19349663 y xor 83492791 z) mod n, on unsigned values.
#define FORWARD_RANGES 14

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    return (73856093u * u.x ^ 19349663u * u.y ^ 83492791u * u.z) & step.cellMask;
}

ivec3 forwardCell(ivec3 c, int range)
{
    int n = range + 13;
    return c + ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
}

/// First cell and the one behind the last, in the order of the sorted particles. Range 0 begins with the own cell.
uvec2 forwardCells(ivec3 c, int range)
{
    uint first = cellIndex(forwardCell(c, range));
    return uvec2(first, first + 1u);
}

// Two of the 27 cells may share a bucket: only what lies in the cell asked for counts.
bool inForwardRange(ivec3 c, int range, vec3 x)
{
    return cellOf(x) == forwardCell(c, range);
}

// All cells around.
#define AROUND_RANGES 27

ivec3 aroundCell(ivec3 c, int range)
{
    return c + ivec3(range % 3 - 1, range / 3 % 3 - 1, range / 9 - 1);
}

uvec2 aroundCells(ivec3 c, int range)
{
    uint first = cellIndex(aroundCell(c, range));
    return uvec2(first, first + 1u);
}

bool inAroundRange(ivec3 c, int range, vec3 x)
{
    return cellOf(x) == aroundCell(c, range);
}

// All cells up to two away.
#define FAR_RANGES 125

ivec3 farCell(ivec3 c, int range)
{
    return c + ivec3(range % 5 - 2, range / 5 % 5 - 2, range / 25 - 2);
}

uvec2 farCells(ivec3 c, int range)
{
    uint first = cellIndex(farCell(c, range));
    return uvec2(first, first + 1u);
}

bool inFarRange(ivec3 c, int range, vec3 x)
{
    return cellOf(x) == farCell(c, range);
}

#else

// A lattice wrapped onto a line. Neighbours in x are neighbours on the line, so three cells are one range; the first
// WRAPPED_CELLS cells stand again behind the last, so that a range never wraps.
#define FORWARD_RANGES 5

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    return (u.x + step.cellStrideY * u.y + step.cellStrideZ * u.z) & step.cellMask;
}

/// First cell and the one behind the last, in the order of the sorted particles. Range 0 begins with the own cell.
uvec2 forwardCells(ivec3 c, int range)
{
    int n = range + 4;
    uint first = cellIndex(c + ivec3(range == 0 ? 0 : -1, n % 3 - 1, n / 3 - 1));
    return uvec2(first, first + (range == 0 ? 2u : 3u));
}

bool inForwardRange(ivec3 c, int range, vec3 x)
{
    return true;
}

// All cells around.
#define AROUND_RANGES 9

uvec2 aroundCells(ivec3 c, int range)
{
    uint first = cellIndex(c + ivec3(-1, range % 3 - 1, range / 3 - 1));
    return uvec2(first, first + 3u);
}

bool inAroundRange(ivec3 c, int range, vec3 x)
{
    return true;
}

// All cells up to two away.
#define FAR_RANGES 25

uvec2 farCells(ivec3 c, int range)
{
    uint first = cellIndex(c + ivec3(-2, range % 5 - 2, range / 5 - 2));
    return uvec2(first, first + 5u);
}

bool inFarRange(ivec3 c, int range, vec3 x)
{
    return true;
}

#endif
