// Rays through the depth picture, in its pixels: no more than a division a step.
#include "render/common/rays/fluid_side.glsl"

/// A ray by window coordinates times depth, and depth: where it starts, and what a metre adds.
struct PictureRay {
    vec3 start, way;
};

vec3 windowOf(vec3 v)
{
    vec2 size = vec2(frame.width, frame.height), middle = 0.5 * size * (1.0 + pictureShift());
    return vec3(0.5 * size.y / frame.tanHalfFov * v.xy - v.z * middle, -v.z);
}

/// A point of a ray: how far along [m], and how far behind it things are [m].
vec2 pointOf(PictureRay ray, float far)
{
    vec3 there = ray.start + far * ray.way;
    ivec2 pixel = clamp(ivec2(there.xy / there.z), ivec2(0), ivec2(frame.width, frame.height) - 1);
    return vec2(far, texelFetch(depthPicture, pixel, 0).r * frame.farDepth - there.z);
}
