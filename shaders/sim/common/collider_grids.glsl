// Colliders that are made of grids (sim/world/collider_grid.h), in their own frames.

uniform samplerBuffer gridValues;

/// Where a point is in a grid.
struct GridPlace {
    int first;           // the value before it on all axes
    vec3 share;          // of the values behind it
    vec3 outside;        // from the grid to the point [m]
};

GridPlace gridPlace(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    vec3 last = vec3(grid.xyz) - 1.0;
    vec3 place = clamp((p - low) / cell, vec3(0), last);
    ivec3 before = max(min(ivec3(place), ivec3(grid.xyz) - 2), 0);
    int first = int(grid.w) + (before.z * int(grid.y) + before.y) * int(grid.x) + before.x;
    return GridPlace(first, place - vec3(before), p - clamp(p, low, low + cell * last));
}

/// Two values in a row along x.
vec2 gridPair(int index)
{
    return vec2(texelFetch(gridValues, index).x, texelFetch(gridValues, index + 1).x);
}

/// Trilinear, with its gradient as the normal; outside the grid a lower bound that meets it there.
vec4 meshSurface(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    GridPlace at = gridPlace(p, low, cell, grid);
    int row = int(grid.x), layer = row * int(grid.y);
    vec4 left, right;    // of the four rows: (y, z) = (0, 0), (1, 0), (0, 1), (1, 1)
    for (int k = 0; k < 4; ++k) {
        vec2 pair = gridPair(at.first + (k & 1) * row + (k >> 1) * layer);
        left[k] = pair.x;
        right[k] = pair.y;
    }
    vec4 rows = mix(left, right, at.share.x), across = right - left;
    vec2 layers = mix(rows.xz, rows.yw, at.share.y);
    vec2 acrossLayers = mix(across.xz, across.yw, at.share.y);
    float distance = mix(layers.x, layers.y, at.share.z);
    vec3 slope = vec3(mix(acrossLayers.x, acrossLayers.y, at.share.z),
                      mix(rows.y - rows.x, rows.w - rows.z, at.share.z), layers.y - layers.x);
    float steep = length(slope), far = length(at.outside);
    return vec4(steep > 0.0 ? slope / steep : vec3(0, 1, 0), far > 0.0 ? max(distance - far, far) : distance);
}

/// The plane that touches the bilinear surface above or below the point; beyond the field's edge, the block of which
/// the field is the top.
vec4 heightfieldSurface(vec3 p, vec3 low, vec3 cell, uvec4 grid)
{
    GridPlace at = gridPlace(p, low, cell, grid);
    vec2 near = gridPair(at.first), behind = gridPair(at.first + int(grid.x));
    vec2 along = mix(near, behind, at.share.z);
    vec2 across = mix(vec2(near.x, behind.x), vec2(near.y, behind.y), at.share.x);
    float above = p.y - mix(along.x, along.y, at.share.x);
    vec3 normal = normalize(vec3((along.x - along.y) / cell.x, 1, (across.x - across.y) / cell.z));
    vec3 off = vec3(at.outside.x, max(above, 0.0), at.outside.z);
    float far = length(off);
    return at.outside.xz == vec2(0) ? vec4(normal, above * normal.y) : vec4(off / far, far);
}
