// The grid in which buried particles are found.
#include "shared/frame_blocks.glsl"

// The cell of a position, clamped to the grid.
uint burialCell(vec3 position)
{
    vec3 place = (position - view.cellOrigin.xyz) / view.cellSize.xyz;
    uvec3 cell = uvec3(clamp(place, vec3(0.0), vec3(float(BURIAL_CELLS) - 1.0)));
    return (cell.z * BURIAL_CELLS + cell.y) * BURIAL_CELLS + cell.x;
}
