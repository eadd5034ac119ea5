// Colliders, where they are now: signed distance of a point and the direction out of the obstacle.
#include "math/quaternion.glsl"
#ifdef GRIDS
#include "sim/common/contacts/collider_grids.glsl"
#endif

uniform usamplerBuffer colliders;    // a Collider in every four texels
uniform samplerBuffer colliderPlaces;

Collider colliderAt(uint index)
{
    uvec4 texels[4];
    for (int k = 0; k < 4; ++k) texels[k] = texelFetch(colliders, int(4u * index) + k);
    return Collider(uintBitsToFloat(texels[0]), uintBitsToFloat(texels[1]), uintBitsToFloat(texels[2]), texels[3]);
}

/// Where a collider is.
struct ColliderPlace {
    vec3 position;       // [m]
    vec4 orientation;
};

ColliderPlace fetchColliderPlace(uint index)
{
    int first = int(2u * index);
    return ColliderPlace(texelFetch(colliderPlaces, first).xyz, texelFetch(colliderPlaces, first + 1));
}

uint colliderShape(Collider collider) { return uint(collider.size.w); }

/// A point of the world, as a collider sees it [m].
vec3 inColliderFrame(ColliderPlace place, vec3 x)
{
    return rotate(conjugate(place.orientation), x - place.position);
}

/// Static and kinetic.
vec2 fetchColliderFriction(uint index)
{
    return colliderAt(index).friction.xy;
}

/// The point of a collider's surface that is nearest to a point.
struct ColliderSurface {
    vec3 normal;      // outward, unit
    float distance;   // to it, negative inside [m]
};

ColliderSurface colliderSurface(uint index, vec3 x)
{
    Collider c = colliderAt(index);
    uint shape = colliderShape(c);
    ColliderPlace place = fetchColliderPlace(index);
    vec3 p = inColliderFrame(place, x);
    vec3 normal = vec3(0, 1, 0);
    float gap = p.y;
    if (shape == COLLIDER_BOX) {
        vec3 q = abs(p) - c.size.xyz;
        vec3 side = vec3(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0, p.z < 0.0 ? -1.0 : 1.0);
        vec3 outside = max(q, 0.0);
        float apart = length(outside);
        float inner = max(q.x, max(q.y, q.z));
        vec3 face = q.x >= inner ? vec3(1, 0, 0) : q.y >= inner ? vec3(0, 1, 0) : vec3(0, 0, 1);
        gap = apart > 0.0 ? apart : inner;
        normal = side * (apart > 1e-9 ? outside / apart : face);
    } else if (shape == COLLIDER_SPHERE || shape == COLLIDER_CAPSULE) {
        float halfHeight = shape == COLLIDER_CAPSULE ? c.size.y : 0.0;
        vec3 fromAxis = p - vec3(0, clamp(p.y, -halfHeight, halfHeight), 0);
        float apart = length(fromAxis);
        gap = apart - c.size.x;
        normal = apart > 1e-9 ? fromAxis / apart : vec3(1, 0, 0);
    }
#ifdef GRIDS
    if (shape >= COLLIDER_MESH) {
        vec4 surface = shape == COLLIDER_MESH ? meshSurface(p, c.gridLow.xyz, c.size.xyz, c.grid)
                                              : heightfieldSurface(p, c.gridLow.xyz, c.size.xyz, c.grid);
        normal = surface.xyz;
        gap = surface.w;
    }
#endif
    return ColliderSurface(rotate(place.orientation, normal), gap);
}

/// A lower bound of the distance from a point to a collider [m]. Of a heightfield none is known:
/// colliderSurface() takes the plane that touches it above or below the point, and the field may rise beside that.
/// Outside a mesh's grid it is the distance to the grid.
float colliderBound(uint index, vec3 x)
{
#ifdef GRIDS
    Collider c = colliderAt(index);
    if (colliderShape(c) == COLLIDER_HEIGHTFIELD) return -1e9;
    if (colliderShape(c) == COLLIDER_MESH) {
        vec3 p = inColliderFrame(fetchColliderPlace(index), x);
        float outside = length(outsideGrid(p, c.gridLow.xyz, c.size.xyz, c.grid));
        if (outside > 0.0) return outside;
    }
#endif
    return colliderSurface(index, x).distance;
}
