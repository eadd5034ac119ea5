// Where a pixel's ray meets a sphere.
#include "render/common/frame_blocks.glsl"

struct SphereHit {
    float depth;   // view depth of the nearest point [m]
    vec3 normal;   // there, outwards
};

/// @param centre  In view space. @returns whether the ray through a window coordinate meets it.
bool sphereHit(vec3 centre, float radius, vec2 window, out SphereHit hit)
{
    vec3 ray = viewRay(window);
    float inverse = 1.0 / dot(ray, ray);
    // From the ray's nearest point to the centre: unlike the usual discriminant, this loses no digits far away.
    float along = dot(centre, ray) * inverse;
    vec3 miss = centre - along * ray;
    float h = radius * radius - dot(miss, miss);
    hit.depth = along - sqrt(max(h, 0.0) * inverse);
    hit.normal = (hit.depth * ray - centre) / radius;
    return h >= 0.0;
}
