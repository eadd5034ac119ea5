// Smooths the depth of fluid along rows, or, COLUMNS, along columns of what was smoothed along rows. Pixels count in
// pairs, one on either side: their harmonic mean is the depth here on any plane, however it leans, so that only what
// bends is smoothed. As in the narrow-range filter of Truong and Yuksel (2018), what lies much nearer does not count,
// and what lies much further as a little behind: edges stay where they are, and nothing shrinks. Both set in gradually,
// or neighbouring rows would differ.
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

// In radii: how much further the middle of a pair may be, how far behind what is beyond counts, how much nearer it may
// be, and the filter's half width.
const float RANGE = 1.2, BEYOND = 0.8, NEARER = 0.7, WIDTH = 1.5;
const float MOST_PIXELS = 100.0;
const int MOST_TAPS = 32;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = ivec2(frame.width, frame.height) - 1;
    float here = fluidDepth(pixel);
    bool any = here < frame.farDepth;
    vec2 beside = vec2(fluidDepth(max(pixel - 2 * STEP, ivec2(0))), fluidDepth(min(pixel + 2 * STEP, last)));
    float slant = min(abs(beside.x - here), abs(beside.y - here));
    float radius = frame.fluidRadius;
    float further = 4.0 / (RANGE * radius + slant), nearer = 1.0 / (NEARER * radius + slant);
    float pixels = WIDTH * radius * float(frame.height) / (2.0 * frame.tanHalfFov * max(here, radius));
    pixels = any ? clamp(pixels, 1.0, MOST_PIXELS) : 0.0;
    int step = max(int(ceil(pixels / float(MOST_TAPS))), 1);
    float sum = 0.0, weights = 1.0;
    for (int k = step; float(k) <= pixels; k += step) {
        ivec2 one = pixel - k * STEP, other = pixel + k * STEP;
        vec2 depths = vec2(fluidDepth(clamp(one, ivec2(0), last)), fluidDepth(clamp(other, ivec2(0), last)));
        bool inside = all(greaterThanEqual(one, ivec2(0))) && all(lessThanEqual(other, last));
        // Both or none, or surfaces would lean at their edges.
        bool counts = inside && all(lessThan(depths, vec2(frame.farDepth)));
        float away = 2.0 * depths.x * depths.y / (depths.x + depths.y) - here;
        vec2 bounded = min(depths, vec2(here + BEYOND * radius));
        float taken = mix(0.5 * (bounded.x + bounded.y) - here, away, clamp(5.0 - further * away, 0.0, 1.0));
        float q = float(k) / pixels, share = clamp(2.0 + nearer * away, 0.0, 1.0);
        float weight = counts ? 2.0 * exp(-3.0 * q * q) * share : 0.0;
        sum += weight * taken;
        weights += weight;
    }
    smoothed = any ? here + sum / weights : frame.farDepth;
}
