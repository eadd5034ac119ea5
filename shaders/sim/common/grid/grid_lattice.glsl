// Cells of the grid where they are a lattice (GridKind::Lattice).

// A lattice wrapped onto a line. Neighbours in x are neighbours on the line, so three cells are one range, or three
// times CELLS_ALONG; the first WRAPPED_CELLS cells are repeated after the last, so that a range never wraps.
#define RANGES_AROUND(width) (width * width)
#define FORWARD_OFFSET 4

uint cellIndex(ivec3 c)
{
    uvec3 u = uvec3(c);
    uvec2 strides = gridStrides();
    return (u.x + strides.x * u.y + strides.y * u.z) & gridMask();
}

/// One of the rows of `width` cells along x around c.
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
