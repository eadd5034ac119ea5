// The mean of 4x4 half-resolution pixels that lie at nearly the same depth: takes out the pattern of occlusion.frag.
#include "shared/frame_blocks.glsl"

layout(binding = SHADE_UNIT) uniform sampler2D shadePicture;
layout(location = 0) out vec4 shade;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(shadePicture, 0) - 1;
    vec3 here = texelFetch(shadePicture, pixel, 0).xyz;
    if (here.z <= 0.0) discard;
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    float sharpness = 1.0 / (0.35 * frame.radius + 0.004 * here.z);
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) {
            vec3 there = texelFetch(shadePicture, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).xyz;
            float weight = max(1.0 - abs(there.z - here.z) * sharpness, 0.0) + 1e-4;
            sum += weight * there.xy;
            weights += weight;
        }
    }
    shade = vec4(sum / weights, here.z, 0.0);
}
