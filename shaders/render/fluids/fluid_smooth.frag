// Smooths the depth of fluid along rows, or, COLUMNS, along columns of what was smoothed along rows: a narrow-range
// filter (Truong and Yuksel 2018). Depths out of range do not count if they are nearer, and count as a little behind if
// they are further: so edges stay where they are, and nothing shrinks.
#include "render/common/frame_blocks.glsl"

#ifdef COLUMNS
uniform sampler2D fluidWidePicture;
const ivec2 STEP = ivec2(0, 1);
float fluidDepth(ivec2 pixel) { return texelFetch(fluidWidePicture, pixel, 0).r; }
#else
uniform sampler2D fluidDepthPicture;
const ivec2 STEP = ivec2(1, 0);
float fluidDepth(ivec2 pixel) { return texelFetch(fluidDepthPicture, pixel, 0).r * frame.farDepth; }
#endif
layout(location = 0) out float smoothed;   // [m]

// In radii: the range, how far behind what is beyond it counts, and the filter's half width.
const float RANGE = 2.8, BEYOND = 0.8, WIDTH = 1.5;
const float MOST_PIXELS = 100.0;
const int MOST_TAPS = 32;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.width, frame.height) - 1;
    float here = fluidDepth(pixel);
    bool any = here < frame.farDepth;
    float radius = frame.fluidRadius, range = RANGE * radius;
    float pixels = WIDTH * radius * float(frame.height) / (2.0 * frame.tanHalfFov * max(here, radius));
    pixels = any ? clamp(pixels, 1.0, MOST_PIXELS) : 0.0;
    int step = int(ceil(pixels / float(MOST_TAPS)));
    float low = here - range, high = here + range, sum = here, weights = 1.0;
    for (int k = step; float(k) <= pixels; k += max(step, 1)) {
        ivec2 one = pixel - k * STEP, other = pixel + k * STEP;
        vec2 depths = vec2(fluidDepth(clamp(one, ivec2(0), last)), fluidDepth(clamp(other, ivec2(0), last)));
        bool inside = all(greaterThanEqual(one, ivec2(0))) && all(lessThanEqual(other, last));
        // Both or none, or surfaces would lean at their edges.
        bool counts = inside && all(greaterThan(depths, vec2(low))) && all(lessThan(depths, vec2(frame.farDepth)));
        float q = float(k) / pixels, weight = counts ? exp(-3.0 * q * q) : 0.0;
        bvec2 beyond = greaterThan(depths, vec2(high));
        vec2 taken = mix(depths, vec2(here + BEYOND * radius), beyond);
        sum += weight * (taken.x + taken.y);
        weights += 2.0 * weight;
        if (!counts) continue;
        vec2 within = mix(depths, vec2(here), beyond);
        low = min(low, min(within.x, within.y) - range);
        high = max(high, max(within.x, within.y) + range);
    }
    smoothed = any ? sum / weights : frame.farDepth;
}
