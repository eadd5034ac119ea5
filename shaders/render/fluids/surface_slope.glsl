// Slopes of the smoothed surface.
#include "render/common/frame_blocks.glsl"

uniform sampler2D fluidWidePicture;

vec3 surfacePoint(ivec2 pixel)
{
    return viewRay(vec2(pixel) + 0.5) * texelFetch(fluidWidePicture, pixel, 0).r;
}

/// The change of place from pixel to pixel: the mean of both sides, or at edges that of the side more like this.
/// @param crease  Gets more where both differ. @param turned  Gets the square of the angle between them.
vec3 slopeAlong(ivec2 pixel, ivec2 way, vec3 here, inout float crease, inout float turned)
{
    ivec2 last = ivec2(frame.width, frame.height) - 1;
    vec3 ahead = surfacePoint(min(pixel + way, last)) - here, behind = here - surfacePoint(max(pixel - way, ivec2(0)));
    vec2 sizes = abs(vec2(ahead.z, behind.z));
    if (any(equal(pixel - way, ivec2(-1)))) return ahead;
    if (any(greaterThan(pixel + way, last))) return behind;
    float bend = length(ahead - behind) / max(length(ahead + behind), 1e-9);
    crease += clamp(bend - 0.3, 0.0, 1.0);
    turned += 4.0 * bend * bend;
    if (max(sizes.x, sizes.y) < 1.5 * frame.fluidRadius) return 0.5 * (ahead + behind);
    return sizes.x < sizes.y ? ahead : behind;
}

/// Towards the eye, even at edges. @param p  The place. @param crease, turned  As of slopeAlong().
vec3 surfaceNormal(ivec2 pixel, vec3 p, inout float crease, inout float turned)
{
    vec3 toEye = -normalize(p);
    vec3 n = normalize(cross(slopeAlong(pixel, ivec2(1, 0), p, crease, turned),
                             slopeAlong(pixel, ivec2(0, 1), p, crease, turned)));
    return normalize(n + max(0.05 - dot(n, toEye), 0.0) * toEye);
}
