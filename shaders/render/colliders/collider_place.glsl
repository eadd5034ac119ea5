// Where colliders are: the solver's buffer.
#include "math/quaternion.glsl"

uniform samplerBuffer colliderPlaces;       // two a collider: position; orientation

struct ColliderPlace {
    vec3 position;
    vec4 orientation;
};

ColliderPlace fetchColliderPlace(float index)
{
    int first = 2 * int(index);
    return ColliderPlace(texelFetch(colliderPlaces, first).xyz, texelFetch(colliderPlaces, first + 1));
}
