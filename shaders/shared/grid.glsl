// The neighbour grid: which cell a position is in, and which ranges of the sorted particles are its neighbourhood.

ivec3 cellOf(vec3 x)
{
    return ivec3(floor(x * step.inverseCellSize));
}

#ifdef GRID_HASH

// Teschner et al. 2003: h = (73856093 x xor 19349663 y xor 83492791 z) mod n, on unsigned values.
#define NEIGHBOUR_RANGES 27

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    return (73856093u * u.x ^ 19349663u * u.y ^ 83492791u * u.z) & step.cellMask;
}

ivec3 neighbourCell(ivec3 c, int range)
{
    return c + ivec3(range % 3 - 1, range / 3 % 3 - 1, range / 9 - 1);
}

uvec2 neighbourCells(ivec3 c, int range)
{
    uint first = cellIndex(neighbourCell(c, range));
    return uvec2(first, first + 1u);
}

// Two of the 27 cells may share a bucket: only what lies in the cell asked for counts.
bool inNeighbourRange(ivec3 c, int range, vec3 x)
{
    return cellOf(x) == neighbourCell(c, range);
}

#else

// A lattice wrapped onto a line. Neighbours in x are neighbours on the line, so three cells are one range; the first
// two cells stand again behind the last, so that a range never wraps.
#define NEIGHBOUR_RANGES 9

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    return (u.x + step.cellStrideY * u.y + step.cellStrideZ * u.z) & step.cellMask;
}

uvec2 neighbourCells(ivec3 c, int range)
{
    uint first = cellIndex(c + ivec3(-1, range % 3 - 1, range / 3 - 1));
    return uvec2(first, first + 3u);
}

bool inNeighbourRange(ivec3 c, int range, vec3 x)
{
    return true;
}

#endif
