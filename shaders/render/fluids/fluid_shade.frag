// The surface of fluid over the lit picture: what is seen through it, bent (Snell) and dimmed (Beer and Lambert), what
// comes back from inside, and what it mirrors (Fresnel, Schlick 1994).
#include "render/common/fog.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/sky.glsl"
#include "render/common/tone/tone_map.glsl"
#include "render/fluids/seen_through.glsl"
#include "render/fluids/surface_slope.glsl"

uniform sampler2D fluidTintPicture;
#ifdef EMISSION
uniform sampler2D fluidEmissionPicture;
#endif
layout(location = 0) out vec4 picture;

const float REFRACTION = 1.0 / 1.333;
const float REFLECTION = 0.02;   // of light that falls straight on it
const float SUN_SHARPNESS = 300.0;
// Below this share only the sky is mirrored.
const float MIRRORS_THINGS = 0.025;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(fluidWidePicture, pixel, 0).r;
    if (depth >= texelFetch(depthPicture, pixel, 0).r * frame.farDepth || depth >= frame.farDepth) discard;
    vec3 p = viewRay(gl_FragCoord.xy) * depth, toEye = -normalize(p);
    float crease = 0.0, turned = 0.0;
    vec3 n = surfaceNormal(pixel, p, crease, turned);
    vec2 at = gl_FragCoord.xy / vec2(frame.width, frame.height);
    vec4 tint = textureLod(fluidTintPicture, at, 0.0), glow = textureLod(fluidGlowPicture, at, 0.0);
    BentRay bent = seenThrough(p, refract(-toEye, n, REFRACTION), pixel, glow.a);
    vec3 behind = lightIn(textureLod(litPicture, bent.place, 0.0).rgb) / frame.groundColor.w;
#ifdef FOG   // what is before the fluid comes last
    float clear = clearShare(p, length(p));
    behind = max(mix(frame.fog.rgb, behind, 1.0 / max(clear, 0.05)), 0.0);
#endif
    vec4 dims = tint * bent.longer;
    vec3 through = behind * exp(-dims.rgb - dims.a);
    float key = max(0.7 * dot(n, view.keyInView.xyz) + 0.3, 0.0);
    vec3 light = 0.4 * key * frame.keyColor.rgb +
                 0.6 * mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.5 + 0.5 * dot(n, view.upInView.xyz));
    vec3 back = glow.rgb / max(tint.a, 1e-6) * light * (1.0 - exp(-dims.a)), mirror = reflect(-toEye, n);
#ifdef EMISSION
    vec4 sent = textureLod(fluidEmissionPicture, at, 0.0);
    back += sent.rgb / max(sent.a, 1e-6) * (1.0 - exp(-sent.a));
#endif
    float grazing = 1.0 - max(dot(n, toEye), 0.0);
    float mirrored = REFLECTION + (1.0 - REFLECTION) * pow(grazing, 5.0) * max(1.0 - crease, 0.0);
    // Where the surface turns within a pixel, the sun's image is spread over it (Kaplanyan et al. 2016), and dimmed
    // more than that: edges at walls would have a bright rim.
    float sharpness = 1.0 / (1.0 / SUN_SHARPNESS + turned), dimmed = sharpness / SUN_SHARPNESS;
    float glint = 0.8 * dimmed * dimmed * pow(max(dot(mirror, view.keyInView.xyz), 0.0), sharpness);
    vec3 around = skyTowards(mirror);
    if (mirrored > MIRRORS_THINGS) around = lightAlong(p + 0.002 * depth * n, mirror, around);
    vec3 radiance = mix(through + back, around, mirrored) + glint * frame.keyColor.rgb;
#ifdef FOG
    radiance = mix(frame.fog.rgb, radiance, clear);
#endif
    vec3 color = written(radiance * frame.groundColor.w);
    picture = vec4(color, lightness(color));
}
