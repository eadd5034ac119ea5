// One infinite plane over the whole picture: the ground with its pattern, or a tilted one in its own colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

flat in vec4 planeInView;                       // normal; w: the eye's height above the plane
flat in uint normalWord;
flat in vec4 planeColor;                        // rgb; w: 1 for the ground
layout(location = 0) out uvec2 surface;

// Share of a pixel of width `w` covered by lines of half-width `h` around the whole numbers: the integral of the line
// pattern over the pixel.
vec2 lineCover(vec2 x, vec2 w, float h)
{
    vec2 a = x - 0.5 * w, b = x + 0.5 * w;
    vec2 upTo0 = floor(a + 0.5) * 2.0 * h + clamp(a - floor(a + 0.5), -h, h);
    vec2 upTo1 = floor(b + 0.5) * 2.0 * h + clamp(b - floor(b + 0.5), -h, h);
    return (upTo1 - upTo0) / w;
}

vec3 groundPattern(vec2 place, vec2 width)
{
    vec2 cell = place / frame.patternScale, cellWidth = max(width / frame.patternScale, 1e-4);
    vec2 fine = lineCover(cell, cellWidth, 0.012);
    vec2 coarse = lineCover(cell * 0.2, cellWidth * 0.2, 0.005);
    // A checker faded out where its cells become pixels.
    vec2 side = 1.0 - 2.0 * abs(fract(cell * 0.5) * 2.0 - 1.0);
    vec2 sharp = clamp(side / max(2.0 * cellWidth, 1e-4), -1.0, 1.0);
    float checker = sharp.x * sharp.y * clamp(1.5 - max(cellWidth.x, cellWidth.y), 0.0, 1.0);
    float lines = 1.0 - 0.20 * max(fine.x, fine.y) - 0.22 * max(coarse.x, coarse.y);
    return planeColor.rgb * lines * (1.0 + 0.035 * checker);
}

void main()
{
    vec3 ray = viewRay(gl_FragCoord.xy);
    float fall = -dot(ray, planeInView.xyz);
    float depth = planeInView.w / fall;
    if (planeInView.w <= 0.0 || fall <= 1e-6 || depth >= frame.farDepth) discard;
    vec3 world = view.cameraPosition.xyz + depth * directionToWorld(ray);
    vec3 color = planeColor.rgb;
    if (planeColor.w > 0.5) color = groundPattern(world.xz, fwidth(world.xz));
    surface = uvec2(normalWord, packAlbedo(color, planeColor.w > 0.5 ? 0.0 : 1.0));
    gl_FragDepth = depth / frame.farDepth;
}
