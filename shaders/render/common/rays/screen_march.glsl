// Rays through the depth picture.
#include "render/common/rays/fluid_side.glsl"

const int HALVINGS = 6;
const float ANY_THICKNESS = 1e6;

// How far behind what is in the picture a point is [m].
float behind(vec3 p)
{
    return -p.z - depthAt(pictureOf(p));
}

/// @param steps  Their number; each is `growth` times as long as the one before. @param thick  How far behind what is
/// seen a ray may be to meet it, at most [m].
/// @returns how far along the ray something is met, below 0 if nothing is.
float met(vec3 p, vec3 way, int steps, float growth, float thick)
{
    float from = 0.0, by = 0.4 * frame.radius + 0.002 * -p.z;
    for (int k = 0; k < steps; ++k) {
        float to = from + by;
        vec3 there = p + to * way;
        vec2 place = pictureOf(there);
        bool inside = all(greaterThan(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
        if (-there.z <= 0.0 || !inside) return -1.0;
        float gap = behind(there);
        if (gap > 0.0 && gap < min(2.0 * by + 3.0 * frame.radius, thick)) {
            for (int h = 0; h < HALVINGS; ++h) {
                float middle = 0.5 * (from + to);
                if (behind(p + middle * way) > 0.0) to = middle;
                else from = middle;
            }
            return to;
        }
        from = to;
        by *= growth;
    }
    return -1.0;
}
