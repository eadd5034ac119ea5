// What floors show, each the mean over a pixel: of lines and squares it is their integral, finer things fade to theirs.
#include "math/value_noise.glsl"
#include "render/colliders/line_cover.glsl"
#include "shared/draw_types.h"

// The mean of 1 and -1 in turn from whole number to whole number, over a pixel of width `w`.
vec2 squareWave(vec2 x, vec2 w)
{
    vec2 a = x - 0.5 * w, b = x + 0.5 * w;
    return (abs(2.0 * fract(0.5 * a) - 1.0) - abs(2.0 * fract(0.5 * b) - 1.0)) / w;
}

// How much of what is `size` wide can be seen by a pixel.
float seen(vec2 width, float size)
{
    return clamp(1.5 - max(width.x, width.y) / size, 0.0, 1.0);
}

// Share of a pixel that lines of half-width `h` in both directions cover.
float meshCover(vec2 place, vec2 width, float h)
{
    vec2 cover = lineCover(place, width, h);
    return 1.0 - (1.0 - cover.x) * (1.0 - cover.y);
}

float cellNoise(vec2 cell)
{
    return latticeValue(ivec3(floor(cell), 7));
}

vec3 tileFloor(vec3 color, vec2 place, vec2 width)
{
    float tint = 1.0 + 0.10 * (cellNoise(place) - 0.5) * seen(width, 0.5);
    return color * mix(tint, 0.55, meshCover(place, width, 0.012));
}

vec3 checkerFloor(vec3 color, vec2 place, vec2 width)
{
    vec2 wave = squareWave(place, width);
    return color * (0.62 + 0.38 * wave.x * wave.y);
}

// Planks along x, 0.25 wide and 2 long.
vec3 plankFloor(vec3 color, vec2 place, vec2 width)
{
    float row = floor(4.0 * place.y);
    vec2 along = vec2(0.5 * place.x + latticeValue(ivec3(int(row), 0, 3)), 4.0 * place.y);
    vec2 alongWidth = width * vec2(0.5, 4.0);
    float tint = (cellNoise(along) - 0.5) * seen(width, 0.25);
    vec3 at = vec3(place.x, 9.0 * place.y, 5.0 * cellNoise(along));
    float grain = (valueNoise(at * vec3(1.3, 3.0, 1.0)) - 0.5) * seen(width, 0.04) +
                  (valueNoise(at * vec3(5.0, 14.0, 1.0)) - 0.5) * seen(width, 0.01);
    vec2 gap = lineCover(along, max(alongWidth, 1e-4), 0.008) * vec2(0.25, 1.0);
    return color * vec3(1.0, 0.72, 0.47) * (1.05 + 0.35 * tint + 0.20 * grain) * (1.0 - 0.6 * max(gap.x, gap.y));
}

vec3 grassFloor(vec3 color, vec2 place, vec2 width)
{
    float sum = 0.0, size = 0.5, share = 0.5;
    for (int k = 0; k < 5; ++k) {
        sum += share * (valueNoise(vec3(place / size, float(k))) - 0.5) * seen(width, size);
        size *= 0.37;
        share *= 0.85;
    }
    return color * mix(vec3(0.22, 0.42, 0.10), vec3(0.62, 0.80, 0.28), clamp(0.42 + 0.9 * sum, 0.0, 1.0));
}

// Lines a metre and a tenth of it apart. Both in metres.
vec3 gridFloor(vec3 color, vec2 place, vec2 width)
{
    float fine = meshCover(10.0 * place, 10.0 * width, 0.02), coarse = meshCover(place, width, 0.006);
    return color * (1.0 - 0.35 * fine) * (1.0 - 0.6 * coarse);
}

/// @param look  FLOOR_*. @param place  On the plane [m]. @param scale  What suits the scene [m].
vec3 floorColor(uint look, vec3 color, vec2 place, vec2 width, float scale)
{
    vec2 at = place / scale, atWidth = max(width / scale, 1e-4);
    if (look == FLOOR_TILES) return tileFloor(color, 2.0 * at, 2.0 * atWidth);
    if (look == FLOOR_CHECKER) return checkerFloor(color, 2.0 * at, 2.0 * atWidth);
    if (look == FLOOR_WOOD) return plankFloor(color, 2.0 * at, 2.0 * atWidth);
    if (look == FLOOR_GRASS) return grassFloor(color, 2.0 * at, 2.0 * atWidth);
    if (look == FLOOR_GRID) return gridFloor(color, place, max(width, 1e-5));
    return color;
}
