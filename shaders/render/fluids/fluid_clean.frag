// What rows and columns alone leave behind: the mean over 5 x 5 pixels of those in range, in pairs as in fluid_smooth.
#include "render/common/frame_blocks.glsl"

uniform sampler2D fluidSmoothPicture;
uniform sampler2D fluidDepthPicture;
uniform sampler2D depthPicture;
layout(location = 0) out float cleaned;   // [m]

float depthAt(ivec2 pixel)
{
    ivec2 last = ivec2(frame.width, frame.height) - 1;
    return texelFetch(fluidSmoothPicture, clamp(pixel, ivec2(0), last), 0).r;
}

/// The smaller change of depth to either side; none where there is fluid on neither.
float slantAlong(ivec2 pixel, ivec2 way, float here)
{
    vec2 beside = vec2(depthAt(pixel + way), depthAt(pixel - way)), apart = abs(beside - here);
    return min(beside.x, beside.y) < frame.farDepth ? min(apart.x, apart.y) : 0.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float here = depthAt(pixel), sum = 0.0, weights = 1.0;
    float slant = max(slantAlong(pixel, ivec2(1, 0), here), slantAlong(pixel, ivec2(0, 1), here));
    float inverseRange = 2.0 / (0.3 * frame.fluidRadius + slant);
    // llvmpipe leaves a loop in which no pixel takes part.
    int rows = here < frame.farDepth ? 2 : -1;
    for (int y = 0; y <= rows; ++y)
        for (int x = y == 0 ? 1 : -2; x <= 2; ++x) {
            float away = 0.5 * (depthAt(pixel + ivec2(x, y)) + depthAt(pixel - ivec2(x, y))) - here;
            float weight = max(2.0 - inverseRange * abs(away), 0.0);
            sum += weight * away;
            weights += weight;
        }
    cleaned = here < frame.farDepth ? here + sum / weights : here;
    // What is well before a thing stays before it: smoothed at a slant, it may come to lie behind.
    float unsmoothed = texelFetch(fluidDepthPicture, pixel, 0).r * frame.farDepth;
    float scene = texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
    if (unsmoothed + 0.3 * frame.fluidRadius < scene) cleaned = min(cleaned, scene - 0.01 * frame.fluidRadius);
}
