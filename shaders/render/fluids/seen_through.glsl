// Where rays that the surface has bent meet what is behind it.
#include "render/common/rays/mirrored.glsl"

/// How far behind a bent ray things are, where it has gone that far [m]. @param place  There, as a texture coordinate.
float gapBehind(vec3 p, vec3 way, float far, out vec2 place)
{
    vec3 there = p + far * way;
    place = pictureOf(there);
    return -behind(there);
}

/// Where a bent ray meets what is behind the surface, as a texture coordinate: by secants, which find a plane at once.
/// It is bent only as far as the fluid reaches, `inside` [m].
vec2 seenThrough(vec3 p, vec3 way, ivec2 pixel, float inside)
{
    vec2 straight = (vec2(pixel) + 0.5) / vec2(frame.width, frame.height), place;
    float before = 0.0, gapBefore = texelFetch(depthPicture, pixel, 0).r * frame.farDepth + p.z;
    float far = min(gapBefore / max(-way.z, 0.2), inside), gap = gapBehind(p, way, far, place);
    for (int k = 0; k < 2; ++k) {
        float slope = (gap - gapBefore) / max(far - before, 1e-6), next = far - gap / min(slope, -0.2);
        before = far, gapBefore = gap;
        far = clamp(next, 0.0, inside);
        gap = gapBehind(p, way, far, place);
    }
    // What stands before the fluid is not seen through it.
    return gap - dot(far * way, vec3(0, 0, 1)) > 0.0 ? place : straight;
}
