// Solid colliders that hold off a camera that moves by itself: the nearer one is to the way from what it looks at, for
// its distance from there, the more the camera comes along that way, until it is in front of it.
#include "math/quaternion.glsl"

layout(std430) readonly buffer ColliderPlaces { vec4 colliderPlaces[]; };   // two a collider: position; orientation
layout(std430) readonly buffer CameraSolids { CameraSolid solids[]; };
layout(std430) readonly buffer CameraGrids { float cameraGrids[]; };

// Distances to the way over those along it: the camera begins to give way, and is in front.
const float FREE = 0.2, BLOCKED = 0.04;
// Steps along the way, as shares of it and of the distance to the solid.
const float SHORTEST = 0.004, LONGEST = 0.04, CAREFUL = 0.25;

// Between the values of a grid about a point in it, which is cut to the grid.
float gridValue(CameraSolid solid, vec3 p, out vec3 slope)
{
    uvec3 counts = solid.grid.xyz;
    vec3 place = clamp((p - solid.low.xyz) / solid.cell.xyz, vec3(0.0), vec3(counts - 1u));
    uvec3 cell = min(uvec3(place), uvec3(max(ivec3(counts) - 2, 0)));
    vec3 share = place - vec3(cell);
    float value[8];
    for (uint k = 0u; k < 8u; ++k) {
        uvec3 at = min(cell + uvec3(k & 1u, k >> 1 & 1u, k >> 2), counts - 1u);
        value[k] = cameraGrids[solid.grid.w + (at.z * counts.y + at.y) * counts.x + at.x];
    }
    vec4 near = vec4(value[0], value[2], value[4], value[6]), far = vec4(value[1], value[3], value[5], value[7]);
    vec4 along = mix(near, far, share.x), rise = far - near;
    vec2 layers = mix(along.xz, along.yw, share.y), up = along.yw - along.xz;
    slope = vec3(mix(mix(rise.x, rise.y, share.y), mix(rise.z, rise.w, share.y), share.z), mix(up.x, up.y, share.z),
                 layers.y - layers.x) / solid.cell.xyz;
    return mix(layers.x, layers.y, share.z);
}

// Signed distance to its surface.
float solidDistance(CameraSolid solid, vec3 point)
{
    int first = 2 * int(solid.low.w);
    uint shape = uint(solid.cell.w);
    vec3 p = rotate(conjugate(colliderPlaces[first + 1]), point - colliderPlaces[first].xyz);
    if (shape < COLLIDER_MESH) {
        // Rounded boxes: balls without size, capsules without width and depth.
        vec3 q = abs(p) - solid.extents.xyz;
        return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - solid.extents.w;
    }
    vec3 high = solid.low.xyz + solid.cell.xyz * vec3(solid.grid.xyz - 1u);
    vec3 outside = p - clamp(p, solid.low.xyz, high), slope;
    float value = gridValue(solid, p, slope);
    if (shape == COLLIDER_MESH) return value + length(outside);
    outside.y = 0.0;
    float above = p.y - value;
    if (outside != vec3(0.0)) return length(vec2(length(outside), max(above, 0.0)));
    return above * inversesqrt(1.0 + dot(slope, slope));
}

// How far a camera comes along its way because of one solid.
float freeShare(CameraSolid solid, vec3 target, vec3 way)
{
    float whole = length(way), share = 1.0, at = 0.0, last = 0.0;
    // What it looks at may lie in a hollow of it, or in it.
    if (solidDistance(solid, target) <= 0.0) return share;
    if (solidDistance(solid, target + 0.5 * way) > (0.5 + FREE) * whole) return share;
    while (at < 1.0) {
        float off = solidDistance(solid, target + at * way);
        last = at;
        at = min(at + clamp(CAREFUL * off / whole, SHORTEST, LONGEST), 1.0);
        float ratio = solidDistance(solid, target + at * way) / (at * whole);
        if (ratio > BLOCKED) {
            share = min(share, mix(at, 1.0, smoothstep(BLOCKED, FREE, ratio)));
            continue;
        }
        for (int halving = 0; halving < 8; ++halving) {
            float middle = 0.5 * (last + at);
            if (solidDistance(solid, target + middle * way) > BLOCKED * middle * whole) last = middle;
            else at = middle;
        }
        return min(share, last);
    }
    return share;
}

// How far it comes because of all of them.
float freeWay(vec3 target, vec3 way)
{
    float share = 1.0;
    for (uint i = 0u; i < frame.cameraSolidCount; ++i) share = min(share, freeShare(solids[i], target, way));
    return share;
}

vec3 inFrontOfSolids(vec3 target, vec3 eye)
{
    return mix(target, eye, freeWay(target, eye - target));
}
