// Cells of the grid where they are hashed (GridKind::Hash).

// Teschner et al. 2003: h = (73856093 x xor 19349663 y xor 83492791 z) mod n, on unsigned values.
#define RANGES_AROUND(width) (width * width * width)
#define FORWARD_OFFSET 13

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    return (73856093u * u.x ^ 19349663u * u.y ^ 83492791u * u.z) & gridMask();
}

/// A cell of the cube of width^3 cells around c.
ivec3 cellAround(ivec3 c, int range, int width)
{
    return c + ivec3(range % width, range / width % width, range / (width * width)) - width / 2;
}

uvec2 cellsAround(ivec3 c, int range, int width)
{
    uint first = cellIndex(cellAround(c, range, width));
    return uvec2(first, first + 1u);
}

// Two of the cells may share a bucket: only particles in the cell asked for count.
bool inRangeAround(ivec3 c, int range, int width, vec3 x)
{
    return cellOf(x) == cellAround(c, range, width);
}

uvec2 forwardCells(ivec3 c, int range)
{
    return cellsAround(c, range + FORWARD_OFFSET, 3);
}
