// One thread finds how well a cell hides what is behind it, in layers of a lattice: by its own particles and by those
// of the three layers of 3x3 cells around it, whichever are fewest.
#include "render/spheres/burial.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer BurialCells { uint cells[]; };
layout(std430) writeonly buffer BuriedCells { uint buried[]; };

// Cells with less of what they could hold on a lattice hide nothing. A pile of bodies fills about half.
const float FULL_SHARE = 0.5;

void main()
{
    int cell = int(gl_GlobalInvocationID.x);
    ivec3 place = ivec3(cell, cell / BURIAL_CELLS, cell / (BURIAL_CELLS * BURIAL_CELLS)) % BURIAL_CELLS;
    bool inner = all(greaterThan(place, ivec3(0))) && all(lessThan(place, ivec3(BURIAL_CELLS - 1)));
    uvec3 layers = uvec3(0u);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                int other = cell + (z * BURIAL_CELLS + y) * BURIAL_CELLS + x;
                uint count = cells[clamp(other, 0, BURIAL_CELLS * BURIAL_CELLS * BURIAL_CELLS - 1)];
                layers += count * uvec3(x == 0, y == 0, z == 0);
            }
    float own = float(cells[cell]), least = float(min(min(layers.x, layers.y), layers.z)) / 9.0;
    float share = min(min(own, least) / view.cellSize.w, 1.0);
    float side = min(min(view.cellSize.x, view.cellSize.y), view.cellSize.z);
    float hidden = share >= FULL_SHARE ? share * side / (2.0 * frame.radius) : 0.0;
    buried[cell] = inner ? uint(hidden * float(LAYER_UNITS)) : 0u;
}
