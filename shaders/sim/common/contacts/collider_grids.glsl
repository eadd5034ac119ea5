// Colliders that are made of grids (sim/world/space/collider_grid.h), in their own frames.

uniform samplerBuffer gridValues;

/// From a grid to a point [m].
vec3 outsideGrid(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    return p - clamp(p, low, low + cell * (vec3(grid.xyz) - 1.0));
}

/// Where a point is in a grid.
struct GridPoint {
    int first;           // the value before it on all axes
    vec3 fraction;       // of the way from there to the next value, on each axis
    vec3 outside;        // from the grid to the point [m]
};

GridPoint gridPoint(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    vec3 last = vec3(grid.xyz) - 1.0;
    vec3 index = clamp((p - low) / cell, vec3(0), last);
    ivec3 before = max(min(ivec3(index), ivec3(grid.xyz) - 2), 0);
    int first = int(grid.w) + (before.z * int(grid.y) + before.y) * int(grid.x) + before.x;
    return GridPoint(first, index - vec3(before), outsideGrid(p, low, cell, grid));
}

/// Two values in a row along x.
vec2 gridPair(int index)
{
    return vec2(texelFetch(gridValues, index).x, texelFetch(gridValues, index + 1).x);
}

/// The normal and the distance. Inside the grid: trilinear, with its gradient as the normal. Outside: to the point of
/// the surface that is nearest to where the grid ends, so that the distance grows along the normal there, too.
vec4 meshSurface(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    GridPoint at = gridPoint(p, low, cell, grid);
    int row = int(grid.x), layer = row * int(grid.y);
    vec4 left, right;    // of the four rows: (y, z) = (0, 0), (1, 0), (0, 1), (1, 1)
    for (int k = 0; k < 4; ++k) {
        vec2 pair = gridPair(at.first + (k & 1) * row + (k >> 1) * layer);
        left[k] = pair.x;
        right[k] = pair.y;
    }
    vec4 rows = mix(left, right, at.fraction.x), across = right - left;
    vec2 layers = mix(rows.xz, rows.yw, at.fraction.y);
    vec2 acrossLayers = mix(across.xz, across.yw, at.fraction.y);
    float gap = mix(layers.x, layers.y, at.fraction.z);
    vec3 slope = vec3(mix(acrossLayers.x, acrossLayers.y, at.fraction.z),
                      mix(rows.y - rows.x, rows.w - rows.z, at.fraction.z), layers.y - layers.x);
    float steep = length(slope);
    vec3 normal = steep > 0.0 ? slope / steep : vec3(0, 1, 0);
    if (at.outside == vec3(0)) return vec4(normal, gap);
    vec3 away = at.outside + gap * normal;
    float far = length(away);
    return vec4(far > 0.0 ? away / far : normal, far);
}

/// The plane that touches the bilinear surface above or below the point; beyond the field's edge, the block below the
/// field.
vec4 heightfieldSurface(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    GridPoint at = gridPoint(p, low, cell, grid);
    vec2 near = gridPair(at.first), behind = gridPair(at.first + int(grid.x));
    vec2 along = mix(near, behind, at.fraction.z);
    vec2 across = mix(vec2(near.x, behind.x), vec2(near.y, behind.y), at.fraction.x);
    float above = p.y - mix(along.x, along.y, at.fraction.x);
    vec3 normal = normalize(vec3((along.x - along.y) / cell.x, 1, (across.x - across.y) / cell.z));
    vec3 off = vec3(at.outside.x, max(above, 0.0), at.outside.z);
    float outside = length(off);
    return at.outside.xz == vec2(0) ? vec4(normal, above * normal.y) : vec4(off / outside, outside);
}
