// Where a pixel's ray meets a sphere.

struct SphereHit {
    float depth;   // view depth of the nearest point [m]
    vec3 normal;   // there, outwards; of a sphere as long as its radius
};

/// @param centre  In view space. @param ray of the pixel, as of viewRay(). @returns whether it meets the sphere.
bool sphereHit(vec3 centre, float radius, vec3 ray, out SphereHit hit)
{
    float inverse = 1.0 / dot(ray, ray);
    // From the ray's nearest point to the centre: unlike the usual discriminant, this loses no digits far away.
    float along = dot(centre, ray) * inverse;
    vec3 miss = centre - along * ray;
    float h = radius * radius - dot(miss, miss);
    hit.depth = along - sqrt(max(h, 0.0) * inverse);
    hit.normal = hit.depth * ray - centre;
    return h >= 0.0;
}
