// The surface of fluid over the lit picture: what is seen through it, bent (Snell) and dimmed (Beer and Lambert), what
// comes back from inside, and what it mirrors (Fresnel, Schlick 1994).
#include "render/common/fog.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/sky.glsl"
#include "render/common/tone_map.glsl"

uniform sampler2D litPicture;
uniform sampler2D depthPicture;
uniform sampler2D fluidWidePicture;
uniform sampler2D fluidTintPicture;
uniform sampler2D fluidGlowPicture;
layout(location = 0) out vec4 picture;

const float REFRACTION = 1.0 / 1.333;
const float REFLECTION = 0.02;   // of light that falls straight on it
const float SUN_SHARPNESS = 300.0;

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

/// How far behind a bent ray things are, where it has gone that far [m]. @param place  There, as a texture coordinate.
float gapBehind(vec3 p, vec3 way, float far, out vec2 place)
{
    vec3 there = p + far * way;
    place = clamp(pictureOf(there), vec2(0.0), vec2(1.0));
    return textureLod(depthPicture, place, 0.0).r * frame.farDepth + there.z;
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

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(fluidWidePicture, pixel, 0).r;
    if (depth >= texelFetch(depthPicture, pixel, 0).r * frame.farDepth || depth >= frame.farDepth) discard;
    vec3 p = viewRay(gl_FragCoord.xy) * depth, toEye = -normalize(p);
    float crease = 0.0, turned = 0.0;
    vec3 n = normalize(cross(slopeAlong(pixel, ivec2(1, 0), p, crease, turned),
                             slopeAlong(pixel, ivec2(0, 1), p, crease, turned)));
    n = normalize(n + max(0.05 - dot(n, toEye), 0.0) * toEye);
    vec2 at = gl_FragCoord.xy / vec2(frame.width, frame.height);
    vec4 tint = textureLod(fluidTintPicture, at, 0.0), glow = textureLod(fluidGlowPicture, at, 0.0);
    vec2 place = seenThrough(p, refract(-toEye, n, REFRACTION), pixel, 1.3 * glow.a + frame.fluidRadius);
    vec3 behind = lightIn(textureLod(litPicture, place, 0.0).rgb) / frame.groundColor.w;
#ifdef FOG   // what is before the fluid comes last
    float clear = clearShare(p, length(p));
    behind = max(mix(frame.fog.rgb, behind, 1.0 / max(clear, 0.05)), 0.0);
#endif
    vec3 through = behind * exp(-tint.rgb - tint.a);
    float key = max(0.7 * dot(n, view.keyInView.xyz) + 0.3, 0.0);
    vec3 light = 0.4 * key * frame.keyColor.rgb +
                 0.6 * mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.5 + 0.5 * dot(n, view.upInView.xyz));
    vec3 back = glow.rgb / max(tint.a, 1e-6) * light * (1.0 - exp(-tint.a)), mirror = reflect(-toEye, n);
    float grazing = 1.0 - max(dot(n, toEye), 0.0);
    float mirrored = REFLECTION + (1.0 - REFLECTION) * pow(grazing, 5.0) * max(1.0 - crease, 0.0);
    // Where the surface turns within a pixel, the sun's image is spread over it (Kaplanyan et al. 2016), and dimmed
    // more than that: edges at walls would have a bright rim.
    float sharpness = 1.0 / (1.0 / SUN_SHARPNESS + turned), dimmed = sharpness / SUN_SHARPNESS;
    float glint = 0.8 * dimmed * dimmed * pow(max(dot(mirror, view.keyInView.xyz), 0.0), sharpness);
    vec3 radiance = mix(through + back, skyTowards(mirror), mirrored) + glint * frame.keyColor.rgb;
#ifdef FOG
    radiance = mix(frame.fog.rgb, radiance, clear);
#endif
    vec3 color = written(radiance * frame.groundColor.w);
    picture = vec4(color, lightness(color));
}
