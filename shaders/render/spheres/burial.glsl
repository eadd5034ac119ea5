// The grid for finding buried particles.
#include "render/common/frame_blocks.glsl"

// Particles in a cell that cannot be seen, or whose shadows lie within others.
const uint HIDDEN_FROM_EYE = 1u;
const uint HIDDEN_FROM_LIGHT = 2u;

// How well a cell hides what is behind it is counted in parts of a lattice's layer, and this hides all.
const uint LAYER_UNITS = 64u;
const uint HIDING_UNITS = 6u * LAYER_UNITS;

uint cellIndex(uvec3 cell)
{
    return (cell.z * BURIAL_CELLS + cell.y) * BURIAL_CELLS + cell.x;
}

// A position in cells.
vec3 burialPlace(vec3 position)
{
    return (position - view.cellOrigin.xyz) / view.cellSize.xyz;
}

// The cell of a position, clamped to the grid.
uint burialCell(vec3 position)
{
    return cellIndex(uvec3(clamp(burialPlace(position), vec3(0.0), vec3(float(BURIAL_CELLS) - 1.0))));
}
