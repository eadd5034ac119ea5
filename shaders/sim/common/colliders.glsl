// Static colliders: signed distance of a point and the direction out of the obstacle.
#include "math/quaternion.glsl"
#ifdef GRIDS
#include "sim/common/collider_grids.glsl"
#endif

uniform usamplerBuffer colliders;    // a GpuCollider in every six texels

GpuCollider colliderAt(uint index)
{
    uvec4 texels[6];
    for (int k = 0; k < 6; ++k) texels[k] = texelFetch(colliders, int(6u * index) + k);
    return GpuCollider(uintBitsToFloat(texels[0]), uintBitsToFloat(texels[1]), uintBitsToFloat(texels[2]),
                       uintBitsToFloat(texels[3]), uintBitsToFloat(texels[4]), texels[5]);
}

/// @returns outward unit normal in xyz, signed distance of x to the surface in w (negative inside) [m].
vec4 colliderDistance(uint index, vec3 x)
{
    GpuCollider c = colliderAt(index);
    uint shape = uint(c.position.w);
    vec3 p = rotate(conjugate(c.orientation), x - c.position.xyz);
    vec3 normal = vec3(0, 1, 0);
    float gap = p.y;
    if (shape == COLLIDER_BOX) {
        vec3 q = abs(p) - c.size.xyz;
        vec3 side = vec3(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0, p.z < 0.0 ? -1.0 : 1.0);
        vec3 outside = max(q, 0.0);
        float far = length(outside);
        float inner = max(q.x, max(q.y, q.z));
        vec3 face = q.x >= inner ? vec3(1, 0, 0) : q.y >= inner ? vec3(0, 1, 0) : vec3(0, 0, 1);
        gap = far > 0.0 ? far : inner;
        normal = side * (far > 1e-9 ? outside / far : face);
    } else if (shape == COLLIDER_SPHERE || shape == COLLIDER_CAPSULE) {
        float halfHeight = shape == COLLIDER_CAPSULE ? c.size.y : 0.0;
        vec3 fromAxis = p - vec3(0, clamp(p.y, -halfHeight, halfHeight), 0);
        float far = length(fromAxis);
        gap = far - c.size.x;
        normal = far > 1e-9 ? fromAxis / far : vec3(1, 0, 0);
    }
#ifdef GRIDS
    if (shape >= COLLIDER_MESH) {
        vec4 surface = shape == COLLIDER_MESH ? meshSurface(p, c.gridLow.xyz, c.size.xyz, c.grid)
                                              : heightfieldSurface(p, c.gridLow.xyz, c.size.xyz, c.grid);
        normal = surface.xyz;
        gap = surface.w;
    }
#endif
    return vec4(rotate(c.orientation, normal), gap);
}

/// How near a collider comes to a point, at the most: what a plane touches may rise beside it.
float colliderBound(uint index, vec3 x)
{
#ifdef GRIDS
    if (uint(colliderAt(index).position.w) == COLLIDER_HEIGHTFIELD) return -1e9;
#endif
    return colliderDistance(index, x).w;
}
