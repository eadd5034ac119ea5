// Lines as pixels see them.

// Share of a pixel of width `w` covered by lines of half-width `h` around the whole numbers: the integral of the line
// pattern over the pixel.
vec2 lineCover(vec2 x, vec2 w, float h)
{
    vec2 a = x - 0.5 * w, b = x + 0.5 * w;
    vec2 upTo0 = floor(a + 0.5) * 2.0 * h + clamp(a - floor(a + 0.5), -h, h);
    vec2 upTo1 = floor(b + 0.5) * 2.0 * h + clamp(b - floor(b + 0.5), -h, h);
    return (upTo1 - upTo0) / w;
}
