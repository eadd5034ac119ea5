// The picture of the light of a frame: what the lens does to it, then the curve, then noise that hides steps.
#include "render/common/frame.glsl"
#include "render/common/tone/tone_map.glsl"

uniform sampler2D exposedPicture;
#ifdef BLOOM
uniform sampler2D bloom1Picture;
#endif
layout(location = 0) out vec4 picture;

// 0 to 1, evenly and unlike its neighbours': a lattice of irrational steps (M. Roberts, "The Unreasonable Effectiveness
// of Quasirandom Sequences", 2018) in integers, which are the same on every device.
float noiseAt(uvec2 pixel)
{
    return (float((pixel.x * 3242174889u + pixel.y * 2447445414u) >> 8) + 0.5) / 16777216.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 light = texelFetch(exposedPicture, pixel, 0);
#ifdef BLOOM
    vec2 blurred = 0.5 * gl_FragCoord.xy / vec2(textureSize(bloom1Picture, 0));
    light = mix(light, textureLod(bloom1Picture, blurred, 0.0), frame.develop.y);
#endif
    vec2 outwards = 2.0 * gl_FragCoord.xy / vec2(textureSize(exposedPicture, 0)) - 1.0;
    float far = 0.5 * dot(outwards, outwards);   // 1 in corners
    light.rgb *= 1.0 - frame.develop.z * far * far;
    float cover = clamp(light.a, 0.0, 1.0);
    picture = vec4(displayed(light.rgb / max(cover, 1e-4)) * cover, cover);
#ifdef DITHER
    picture.rgb += (noiseAt(uvec2(pixel)) - 0.5) / 255.0;
#endif
}
