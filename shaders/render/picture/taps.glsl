// Sample points around a pixel, in a pattern that four pixels share.

// A block of 2x2 pixels shares one pattern of four times as many taps; lighting.frag averages such blocks.
const int BLOCK = 4;
// The golden angle, and four times it, as (cos, sin).
const vec2 GOLDEN = vec2(-0.73736888, 0.67549029);
const vec2 GOLDEN_4 = vec2(-0.98468447, 0.17434580);

vec2 turned(vec2 p, vec2 by)
{
    return vec2(p.x * by.x - p.y * by.y, p.x * by.y + p.y * by.x);
}

// Tap `i` of pixel `k` of its block, of `count`: points of a Vogel spiral, spread evenly over the unit disc.
// `direction` starts at pixelDirection(k) and turns by GOLDEN_4 from tap to tap.
vec2 spiral(int i, int k, int count, vec2 direction)
{
    return sqrt((float(BLOCK * i + k) + 0.5) / float(BLOCK * count)) * direction;
}

vec2 pixelDirection(int k)
{
    vec2 once = (k & 1) != 0 ? GOLDEN : vec2(1.0, 0.0);
    return (k & 2) != 0 ? turned(once, turned(GOLDEN, GOLDEN)) : once;
}
