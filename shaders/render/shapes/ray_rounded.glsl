// Rays against rounded boxes: all points within a radius of a box about the origin; balls and capsules are such, too.
#include "render/common/ray_slabs.glsl"

const int STEPS = 4;

/// Parametric distance of the first hit in front of the origin, or a negative number, with the outward normal.
float rayRounded(vec3 origin, vec3 direction, vec3 halfSides, float radius, out vec3 normal)
{
    normal = vec3(0.0, 1.0, 0.0);
    Slabs slabs = raySlabs(origin, direction, halfSides + radius);
    if (!isMet(slabs)) return -1.0;
    float along = max(slabs.enter, 0.0);
    vec3 p = origin + along * direction;
    // The distance from a box is convex along a ray, so Newton's steps come nearer and never go past the hit.
    for (int i = 0; i < STEPS; ++i) {
        vec3 away = p - clamp(p, -halfSides, halfSides);
        float distance = length(away), fall = -dot(away, direction);
        float further = fall > 0.0 ? max(distance - radius, 0.0) * distance / fall : 0.0;
        along += further;
        p += further * direction;
    }
    // The face, the edge or the corner that is nearest now, without end: exact from here.
    vec3 nearest = clamp(p, -halfSides, halfSides);
    vec3 away = p - nearest, rate = direction * vec3(greaterThanEqual(abs(p), halfSides));
    float a = dot(rate, rate), b = dot(away, rate), c = dot(away, away) - radius * radius;
    float root = b * b - a * c;
    if (root < 0.0 || b >= 0.0) return -1.0;
    float further = c / (sqrt(root) - b);
    p += further * direction;
    normal = p - clamp(p, -halfSides, halfSides);
    return along + further;
}
