// Rays against the colliders' shapes, in the shape's own frame: parametric distance of the first hit in front of the
// origin, or a negative number, with the outward normal.
#include "math/quaternion.glsl"
#include "render/common/ray_slabs.glsl"

vec3 rotateBack(vec4 q, vec3 v)
{
    return rotate(conjugate(q), v);
}

float rayBox(vec3 origin, vec3 direction, vec3 halfExtents, out vec3 normal)
{
    Slabs slabs = raySlabs(origin, direction, halfExtents);
    normal = -sign(direction) * vec3(equal(slabs.near, vec3(slabs.enter)));
    normal = normalize(normal + vec3(0.0, 1e-12, 0.0));
    return isMet(slabs) ? slabs.enter : -1.0;
}

// A sphere swept from -halfHeight to +halfHeight along y; halfHeight 0 gives the sphere.
float rayCapsule(vec3 origin, vec3 direction, float radius, float halfHeight, out vec3 normal)
{
    float a = dot(direction.xz, direction.xz);
    float b = dot(origin.xz, direction.xz);
    float side = b * b - a * (dot(origin.xz, origin.xz) - radius * radius);
    normal = vec3(0.0, 1.0, 0.0);
    if (side < 0.0) return -1.0;
    float t = a > 1e-12 ? (-b - sqrt(side)) / a : -1.0;
    float y = origin.y + t * direction.y;
    if (t < 0.0 || abs(y) > halfHeight) {
        // The cap that the ray meets first: on the side it comes from.
        float cap = (t < 0.0 ? -sign(direction.y) : sign(y)) * halfHeight;
        vec3 p = origin - vec3(0.0, cap, 0.0);
        float along = dot(p, direction) / dot(direction, direction);
        vec3 nearest = p - along * direction;
        float h = radius * radius - dot(nearest, nearest);
        t = h >= 0.0 ? -along - sqrt(h / dot(direction, direction)) : -1.0;
        y = origin.y + t * direction.y;
    }
    vec3 hit = origin + t * direction;
    normal = normalize(hit - vec3(0.0, clamp(hit.y, -halfHeight, halfHeight), 0.0) + vec3(0.0, 1e-12, 0.0));
    return t;
}

// `shape`: COLLIDER_BOX, COLLIDER_SPHERE or COLLIDER_CAPSULE; a capsule's halfExtents hold its bounding box.
float rayShape(uint shape, vec3 origin, vec3 direction, vec3 halfExtents, float radius, out vec3 normal)
{
    if (shape == COLLIDER_BOX) return rayBox(origin, direction, halfExtents, normal);
    return rayCapsule(origin, direction, radius, halfExtents.y - radius, normal);
}
