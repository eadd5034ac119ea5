// Colliders, where they are now: signed distance of a point and the direction out of the obstacle.
#include "math/quaternion.glsl"
#include "sim/common/contacts/collider_shapes.glsl"
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

/// Whether it is a plane at rest where an earlier one is.
bool repeatsPlane(uint index)
{
    return colliderAt(index).friction.z > 0.0;
}

/// The point of a collider's surface that is nearest to a point.
struct ColliderSurface {
    vec3 normal;      // outward, unit
    float distance;   // to it, negative inside [m]
};

/// A software driver takes as long for a shape that is not there, so a scene has only the code of its own.
ColliderSurface colliderSurface(uint index, vec3 x)
{
    Collider c = colliderAt(index);
    uint shape = colliderShape(c);
    ColliderPlace place = fetchColliderPlace(index);
    vec3 p = inColliderFrame(place, x);
    vec4 surface = vec4(0, 1, 0, p.y);
#ifdef BOX_REGIONS
    if (shape == COLLIDER_BOX) surface = boxSurface(p, c.size.xyz);
#endif
#ifdef ROUND_REGIONS
    if (shape == COLLIDER_SPHERE) surface = ballSurface(p, c.size.x);
    if (shape == COLLIDER_CAPSULE) surface = ballSurface(p - vec3(0, clamp(p.y, -c.size.y, c.size.y), 0), c.size.x);
#endif
#ifdef GRIDS
    if (shape == COLLIDER_MESH) surface = meshSurface(p, c.gridLow.xyz, c.size.xyz, c.grid);
    if (shape == COLLIDER_HEIGHTFIELD) surface = heightfieldSurface(p, c.gridLow.xyz, c.size.xyz, c.grid);
#endif
    return ColliderSurface(rotate(place.orientation, surface.xyz), surface.w);
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
