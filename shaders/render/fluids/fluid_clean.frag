// What rows and columns alone leave behind: the mean over 5 x 5 pixels of those in range.
#include "render/common/frame_blocks.glsl"

uniform sampler2D fluidSmoothPicture;
layout(location = 0) out float cleaned;   // [m]

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.width, frame.height) - 1;
    float here = texelFetch(fluidSmoothPicture, pixel, 0).r, range = 0.6 * frame.fluidRadius, sum = 0.0, weights = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            float depth = texelFetch(fluidSmoothPicture, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).r;
            float weight = max(1.0 - abs(depth - here) / range, 0.0);
            sum += weight * depth;
            weights += weight;
        }
    cleaned = here < frame.farDepth ? sum / weights : here;
}
