// Patterns of finishes in the body's own space, each faded to its mean where it is finer than pixels.
#include "math/value_noise.glsl"
#include "render/common/finishes.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

// Rings around an axis along x, beside the body, darker to their outer edge, and fibres along the axis.
vec3 woodColor(vec3 color, vec3 place, float width)
{
    float radius = length(place.yz + vec2(2.3, 1.1)) + 0.9 * valueNoise(place * vec3(0.22, 0.55, 0.55));
    float part = fract(radius);
    // The mean of part^3 is 1/4; its edge is a pixel wide.
    float late = mix(0.25, part * part * part * clamp((1.0 - part) / max(width, 0.06), 0.0, 1.0),
                     clamp(1.6 - 2.0 * width, 0.0, 1.0));
    float fibre = (valueNoise(place * vec3(1.2, 11.0, 11.0)) - 0.5) * clamp(1.5 - 11.0 * width, 0.0, 1.0);
    return color * mix(vec3(1.08, 1.06, 1.02), vec3(0.56, 0.44, 0.34), late) * (1.0 + 0.28 * fibre);
}

// Cubes in turn, from the middle of the body on. A face that would lie between two of them shows the inner ones.
vec3 checkerColor(vec3 color, vec3 place, float width)
{
    place *= 0.9;
    vec3 side = 1.0 - 2.0 * abs(fract(0.5 * place + 0.25) * 2.0 - 1.0);
    vec3 sharp = clamp(side / max(2.0 * width, 1e-4), -1.0, 1.0) * clamp(1.5 - width, 0.0, 1.0);
    return color * (0.62 + 0.38 * sharp.x * sharp.y * sharp.z);
}

// Scratches along x.
vec3 brushedColor(vec3 color, vec3 place, float width)
{
    float scratch = valueNoise(place * vec3(0.12, 3.0, 3.0)) + 0.6 * valueNoise(place * vec3(0.3, 7.0, 7.0)) - 0.8;
    return color * (1.0 + 0.4 * scratch * clamp(1.5 - 3.0 * width, 0.0, 1.0));
}

// How wide a pixel is on a surface at a view depth [m]. `normal`: in view space.
float pixelWidth(float depth, vec3 normal)
{
    float slant = max(abs(dot(normal, normalize(viewRay(gl_FragCoord.xy)))), 0.2);
    return 2.0 * frame.tanHalfFov * depth / (float(frame.height) * sqrt(slant));
}

int longestOf(vec3 size)
{
    return size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
}

// A place with what is along an axis first: patterns go along x.
vec3 alongAxis(vec3 place, int axis)
{
    return axis == 0 ? place : axis == 1 ? place.yzx : place.zxy;
}

/// @param word  A surface's colour word. @param place  In the body [m]. @param seed  Of the body, so that no two planks
/// are the same. @param pixel  The width of a pixel there [m].
uint patternedWord(uint word, vec3 place, uint seed, float pixel)
{
    uint alpha = word >> 24;
    if (alpha == FINISH_NONE) return word;
    Finish finish = fetchFinish(alpha);
    if (finish.pattern == PATTERN_NONE) return word;
    vec3 color = unpackAlbedo(word), at = place / finish.patternSize;
    float width = pixel / finish.patternSize;
    if (finish.pattern != PATTERN_CHECKER) at += 7.0 * fract(float(seed) * vec3(0.618034, 0.754878, 0.569840));
    color = finish.pattern == PATTERN_WOOD      ? woodColor(color, at, width)
            : finish.pattern == PATTERN_CHECKER ? checkerColor(color, at, width)
                                                : brushedColor(color, at, width);
    return packAlbedo(color, 0.0) | alpha << 24;
}
