// What comes to the eye from a lit surface.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/sky.glsl"
#include "render/picture/shade.glsl"
#ifdef FLUIDS
#include "render/picture/fluid_shadow.glsl"
#endif

uniform usampler2D shadePicture;

// Diffuse reflection of the key light is 1/pi of the light that arrives; these are that and the sky's, balanced by eye.
const float KEY_SHARE = 0.40;
const float AMBIENT_SHARE = 0.62;

#ifdef BOUNCE
#include "render/picture/bounce.glsl"
#endif
#ifdef LIGHTS
#include "render/picture/light_sources.glsl"
#endif
#ifdef FINISHES
#include "render/picture/finished_surface.glsl"
#endif

// The half-resolution shade: the mean over a block of 2x2, which together hold the whole pattern of taps, of pixels at
// about this depth.
vec2 shadeAt(ivec2 pixel, float depth, float facing)
{
    uvec4 block = textureGather(shadePicture, vec2((pixel >> 1) + 1) / vec2(textureSize(shadePicture, 0)));
    // The depth of a slanted surface changes from pixel to pixel.
    float slope = 2.0 * frame.tanHalfFov / float(frame.height) * depth / max(facing, 0.08);
    float sharpness = 1.0 / (0.3 * frame.radius + 6.0 * slope);
    vec4 weights = max(1.0 - abs(shadeDepth(block) - depth) * sharpness, 0.001);
    weights /= dot(weights, vec4(1.0));
    return vec2(dot(weights, shadeAmbient(block)), dot(weights, shadeKey(block)));
}

// Colour that shines like the key light where it faces it, 1 at most.
float glossOf(vec3 n, vec3 way, vec3 toEye)
{
    float gloss = max(dot(n, normalize(way + toEye)), 0.0);
    gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss;
    return gloss;
}

vec3 litSurface(ivec2 pixel, vec3 p, uvec2 surface, float depth)
{
    vec3 n = unpackNormal(surface.x);
    vec3 albedo = unpackAlbedo(surface.y);
    vec3 toEye = -normalize(p);
    float upright = max(dot(n, toEye), 0.0);
    vec2 reach = shadeAt(pixel, depth, upright);
    vec3 key = view.keyInView.xyz;
    vec3 through = vec3(1.0);
#ifdef FLUIDS
    through = throughFluid(p);
#endif
    vec3 facing = max(dot(n, key), 0.0) * reach.y * through;

#ifdef BOUNCE
    vec3 below = lightFromBelow(p);
#else
    vec3 below = frame.groundColor.rgb;
#endif
    vec3 sky = mix(below, frame.skyColor.rgb, 0.5 + 0.5 * dot(n, view.upInView.xyz));
    // Light between pale surfaces bounces on (Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate
    // Indirect Occlusion", eq. 10).
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    vec3 ambient = max(vec3(reach.x), ((reach.x * a + b) * reach.x + c) * reach.x);
#ifdef FINISHES
    if (hasFinish(surface.y >> 24))
        return finishedSurface(fetchFinish(surface.y >> 24), albedo, Facing(n, toEye, max(upright, 1e-3)), p, reach,
                               through, sky * ambient);
#endif
    vec3 light = albedo * (frame.keyColor.rgb * facing * KEY_SHARE + sky * ambient * AMBIENT_SHARE);

    float grazing = 1.0 - upright;
    float grazing2 = grazing * grazing;
    float gloss = glossOf(n, key, toEye);
    vec3 sheen = frame.keyColor.rgb * (0.05 * gloss * facing) + sky * (0.16 * grazing2 * grazing2 * reach.x * reach.x);
#ifdef LIGHTS
    for (int k = 0; k < LIGHTS; ++k) {
        vec3 strength, way = sourceWay(k, p, n, strength);
        vec3 arriving = strength * max(dot(n, way), 0.0);
        light += albedo * arriving * KEY_SHARE;
        sheen += arriving * (0.05 * glossOf(n, way, toEye));
    }
#endif
    return light + (isGround(surface) ? vec3(0.0) : sheen);
}
