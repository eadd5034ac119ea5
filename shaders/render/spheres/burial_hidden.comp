// One thread decides whether particles in one cell are hidden from the eye and the light: if a buried cell is in the
// way from each of its corners. Those of a buried cell may be seen through the gaps of the one layer of cells before
// it, where particles stand in rows.
#include "render/spheres/burial.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
// Space taken by particles, before; HIDDEN_*, after.
layout(std430) buffer BurialCells { uint cells[]; };
layout(std430) readonly buffer BuriedCells { uint buried[]; };

// Walks through the grid from cell to cell. `way`: 1 along its longest axis, in cells.
bool isHidden(vec3 place, vec3 way, int cellCount)
{
    uint layers = 0u;
    bool inside = true;
    for (int i = 0; i < cellCount && inside && layers < HIDING_UNITS; ++i) {
        vec3 middle = place + (float(i) + 0.5) * way;
        inside = all(greaterThanEqual(middle, vec3(0.0))) && all(lessThan(middle, vec3(float(BURIAL_CELLS))));
        if (inside) layers += buried[cellIndex(uvec3(clamp(middle, vec3(0.0), vec3(float(BURIAL_CELLS - 1)))))];
    }
    return layers >= HIDING_UNITS;
}

bool hiddenFrom(vec3 low, vec3 eye, bool farAway)
{
    for (int corner = 0; corner < 8; ++corner) {
        vec3 from = low + vec3(corner & 1, corner >> 1 & 1, corner >> 2);
        vec3 way = farAway ? eye : eye - from;
        float cellCount = max(max(abs(way.x), abs(way.y)), abs(way.z));
        int limit = farAway ? BURIAL_CELLS : int(min(cellCount, float(BURIAL_CELLS)));
        if (!isHidden(from, way / cellCount, limit)) return false;
    }
    return true;
}

void main()
{
    uint cell = gl_GlobalInvocationID.x;
    uvec3 place = uvec3(cell, cell / BURIAL_CELLS, cell / (BURIAL_CELLS * BURIAL_CELLS)) % uint(BURIAL_CELLS);
    // The outermost cells also hold particles far outside.
    bool inner = all(greaterThan(place, uvec3(0u))) && all(lessThan(place, uvec3(BURIAL_CELLS - 1)));
    if (cells[cell] == 0u || !inner) {
        cells[cell] = 0u;
        return;
    }
    vec3 low = vec3(place);
    cells[cell] = (hiddenFrom(low, burialPlace(view.cameraPosition.xyz), false) ? HIDDEN_FROM_EYE : 0u) |
                  (hiddenFrom(low, frame.keyDirection.xyz / view.cellSize.xyz, true) ? HIDDEN_FROM_LIGHT : 0u);
}
