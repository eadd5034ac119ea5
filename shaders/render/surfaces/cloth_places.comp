// One thread puts a vertex of cloth on the cubic B-spline through its grid of particles; beside a torn cell, between
// the particles of its own cell alone. Beyond an edge the sheet goes on straight.
#include "render/common/frame.glsl"
#include "shared/matter_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer ClothSheets { ClothSheet sheets[]; };
layout(std430) writeonly buffer SurfacePlaces { vec4 places[]; };
uniform usamplerBuffer clothVertices;       // sheet, column and row of the surface
uniform usamplerBuffer clothNodes;          // particles
uniform samplerBuffer positions;
#ifdef TEARS
uniform usamplerBuffer clothTorn;           // by cell

bool isTornAround(ClothSheet sheet, ivec2 cell)
{
    ivec2 cells = ivec2(sheet.columns, sheet.rows) - 1;
    uint torn = 0u;
    for (int k = 0; k < 9; ++k) {
        ivec2 other = clamp(cell + ivec2(k % 3, k / 3) - 1, ivec2(0), cells - 1);
        torn |= texelFetch(clothTorn, int(sheet.firstCell) + other.y * cells.x + other.x).x;
    }
    return torn != 0u;
}
#endif

/// Weights of the nodes from before a cell to behind the next, at a part of the cell.
vec4 splineWeights(float t)
{
    float s = 1.0 - t;
    vec3 first = vec3(s * s * s, 4.0 - 6.0 * t * t + 3.0 * t * t * t, 4.0 - 6.0 * s * s + 3.0 * s * s * s);
    return vec4(first, t * t * t) / 6.0;
}

/// Nodes beyond the edge are as far from it as those within.
vec4 foldedWeights(vec4 w, int cell, int nodes)
{
    if (cell == 0) w = vec4(0.0, w.y + 2.0 * w.x, w.z - w.x, w.w);
    if (cell + 2 == nodes) w = vec4(w.x, w.y - w.w, w.z + 2.0 * w.w, 0.0);
    return w;
}

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= textureSize(clothVertices)) return;
    uvec4 which = texelFetch(clothVertices, vertex);
    ClothSheet sheet = sheets[which.x];
    ivec2 nodes = ivec2(sheet.columns, sheet.rows), fine = ivec2(which.yz);
    if (sheet.rows == 0u) {
        places[vertex] = texelFetch(positions, int(texelFetch(clothNodes, int(sheet.firstNode) + fine.x).x));
        return;
    }
    ivec2 cell = min(fine / int(sheet.steps), nodes - 2);
    vec2 part = vec2(fine - cell * int(sheet.steps)) / float(sheet.steps);
    vec4 across = foldedWeights(splineWeights(part.x), cell.x, nodes.x);
    vec4 along = foldedWeights(splineWeights(part.y), cell.y, nodes.y);
#ifdef TEARS
    if (isTornAround(sheet, cell)) {
        across = vec4(0.0, 1.0 - part.x, part.x, 0.0);
        along = vec4(0.0, 1.0 - part.y, part.y, 0.0);
    }
#endif
    vec3 place = vec3(0.0);
    for (int k = 0; k < 16; ++k) {
        ivec2 node = clamp(cell + ivec2(k % 4, k / 4) - 1, ivec2(0), nodes - 1);
        uint particle = texelFetch(clothNodes, int(sheet.firstNode) + node.y * nodes.x + node.x).x;
        place += across[k % 4] * along[k / 4] * texelFetch(positions, int(particle)).xyz;
    }
    places[vertex] = vec4(place, 0.0);
}
