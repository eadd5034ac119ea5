// Lights the surfaces and paints the sky behind them; writes final colours.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/picture/shade.glsl"
#include "render/common/sky.glsl"
#include "render/common/tone_map.glsl"
#ifdef FLUIDS
#include "render/common/fluid_shadow.glsl"
#endif

uniform sampler2D depthPicture;
uniform usampler2D surfacePicture;
uniform usampler2D shadePicture;
layout(location = 0) out vec4 picture;

// Diffuse reflection of the key light is 1/pi of the light that arrives; these are that and the sky's, balanced by eye.
const float KEY_SHARE = 0.40;
const float AMBIENT_SHARE = 0.62;

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

vec3 litSurface(ivec2 pixel, vec3 p, uvec2 surface, float depth)
{
    vec3 n = unpackNormal(surface.x);
    vec3 albedo = unpackAlbedo(surface.y);
    vec3 toEye = -normalize(p);
    float upright = max(dot(n, toEye), 0.0);
    vec2 reach = shadeAt(pixel, depth, upright);
    vec3 key = view.keyInView.xyz;
    vec3 facing = max(dot(n, key), 0.0) * reach.y * vec3(1.0);
#ifdef FLUIDS
    facing *= throughFluid(p);
#endif
    vec3 halfway = normalize(key + toEye);

    vec3 sky = mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.5 + 0.5 * dot(n, view.upInView.xyz));
    // Light between pale surfaces bounces on (Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate
    // Indirect Occlusion", eq. 10).
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    vec3 ambient = max(vec3(reach.x), ((reach.x * a + b) * reach.x + c) * reach.x);
    vec3 light = albedo * (frame.keyColor.rgb * facing * KEY_SHARE + sky * ambient * AMBIENT_SHARE);

    float grazing = 1.0 - upright;
    float grazing2 = grazing * grazing;
    float gloss = max(dot(n, halfway), 0.0);
    gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss;
    vec3 sheen = frame.keyColor.rgb * (0.05 * gloss * facing) + sky * (0.16 * grazing2 * grazing2 * reach.x * reach.x);
    return light + (isGround(surface) ? vec3(0.0) : sheen);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
    vec3 ray = viewRay(gl_FragCoord.xy);
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).xy;
#ifdef VEIL
    if (depth >= frame.farDepth || isGround(surface)) discard;
#endif
    vec3 lit = litSurface(pixel, ray * depth, surface, depth);
    vec3 sky = skyRadiance(dot(normalize(ray), view.upInView.xyz));
    float far = depth * length(ray) / frame.groundFade;
    float haze = isGround(surface) ? far * far / (1.0 + far * far) : 0.0;
    vec3 radiance = depth >= frame.farDepth ? sky : mix(lit, horizonColor(), haze);
    vec3 color = filmic(radiance * frame.groundColor.w);
    // The edge filter compares lightness, as the eye sees it.
    picture = vec4(color, dot(color, vec3(0.299, 0.587, 0.114)));
}
