// One thread decides whether a cell is buried, so that nothing is seen or lit through it: if each of the six layers of
// 3x3 cells around it is full.
#include "render/spheres/burial.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer BurialCells { uint cells[]; };
layout(std430) writeonly buffer BuriedCells { uint buried[]; };

void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    ivec3 place = ivec3(cell, cell / BURIAL_CELLS, cell / (BURIAL_CELLS * BURIAL_CELLS)) % BURIAL_CELLS;
    bool inner = all(greaterThan(place, ivec3(0))) && all(lessThan(place, ivec3(BURIAL_CELLS - 1)));
    uvec3 below = uvec3(0u), above = uvec3(0u);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                int other = cell + (z * BURIAL_CELLS + y) * BURIAL_CELLS + x;
                uint count = cells[clamp(other, 0, BURIAL_CELLS * BURIAL_CELLS * BURIAL_CELLS - 1)];
                below += count * uvec3(x < 0, y < 0, z < 0);
                above += count * uvec3(x > 0, y > 0, z > 0);
            }
    bool full = all(greaterThanEqual(vec3(min(below, above)), vec3(9.0 * view.cellSize.w)));
    buried[cell] = inner && full ? 1u : 0u;
}
