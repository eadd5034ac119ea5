// What a ray that is mirrored or bent meets in the picture. What the camera does not see, as the undersides of things,
// is not mirrored either: its front is.
#include "render/common/frame_blocks.glsl"
#include "render/common/tone/tone_map.glsl"

uniform sampler2D litPicture;
uniform sampler2D depthPicture;

const int HALVINGS = 6;

// How far behind what is in the picture a point is [m].
float behind(vec3 p)
{
    return -p.z - textureLod(depthPicture, pictureOf(p), 0.0).r * frame.farDepth;
}

/// @param steps  Their number; each is `growth` times as long as the one before.
/// @returns how far along the ray something is met, below 0 if nothing is.
float met(vec3 p, vec3 way, int steps, float growth)
{
    float from = 0.0, by = 0.4 * frame.radius + 0.002 * -p.z;
    for (int k = 0; k < steps; ++k) {
        float to = from + by;
        vec3 there = p + to * way;
        vec2 place = pictureOf(there);
        bool inside = all(greaterThan(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
        if (-there.z <= 0.0 || !inside) return -1.0;
        float gap = behind(there);
        if (gap > 0.0 && gap < 2.0 * by + 3.0 * frame.radius) {
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

/// Share of what is met at a place of the picture: it fades to its edges, beyond which nothing is known.
float knownShare(vec2 place)
{
    vec2 edge = clamp(12.0 * min(place, 1.0 - place), 0.0, 1.0);
    return edge.x * edge.y;
}

/// What comes along a ray, all in view space: from what it meets in 24 steps, or else `rest`.
vec3 lightAlong(vec3 p, vec3 way, vec3 rest)
{
    float along = met(p, way, 24, 1.2);
    if (along < 0.0) return rest;
    vec2 place = pictureOf(p + along * way);
    return mix(rest, lightIn(textureLod(litPicture, place, 0.0).rgb) / frame.groundColor.w, knownShare(place));
}
