// What a ray that is mirrored or bent meets in the picture. What the camera does not see, as the undersides of things,
// is not mirrored either: its front is.
#include "render/common/rays/screen_march.glsl"
#include "render/common/tone/tone_map.glsl"

uniform sampler2D litPicture;

/// Share of what is met at a place of the picture: it fades to its edges, beyond which nothing is known.
float knownShare(vec2 place)
{
    vec2 edge = clamp(12.0 * min(place, 1.0 - place), 0.0, 1.0);
    return edge.x * edge.y;
}

/// What comes along a ray, all in view space: from what it meets in 24 steps, or else `rest`.
vec3 lightAlong(vec3 p, vec3 way, vec3 rest)
{
    float along = met(p, way, 24, 1.2, ANY_THICKNESS);
    if (along < 0.0) return rest;
    vec2 place = pictureOf(p + along * way);
    return mix(rest, lightIn(textureLod(litPicture, place, 0.0).rgb) / frame.groundColor.w, knownShare(place));
}
