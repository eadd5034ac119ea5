// One infinite plane over the whole picture: the ground with its pattern, or a tilted one in its own colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"
#include "render/colliders/line_cover.glsl"
#ifdef FLOORS
#include "math/quaternion.glsl"
#include "render/colliders/floor_looks.glsl"

flat in vec3 planeOrigin;
flat in vec4 planeTurn;
#endif

flat in vec4 planeInView;                       // normal; w: the eye's height above the plane
flat in uint normalWord;
flat in vec4 planeColor;                        // rgb; w: 1 for the ground
flat in uvec2 planeLook;                        // FLOOR_*; finish
layout(location = 0) out uvec2 surface;

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
    if (planeColor.w > 0.5 && planeLook.x == 0u) color = groundPattern(world.xz, fwidth(world.xz));
#ifdef FLOORS
    vec2 place = rotate(conjugate(planeTurn), world - planeOrigin).xz;
    if (planeLook.x != 0u) color = floorColor(planeLook.x, color, place, fwidth(place), frame.patternScale);
#endif
    surface = uvec2(normalWord, packAlbedo(color, 0.0) | (planeColor.w > 0.5 ? 0u : planeLook.y << 24));
    gl_FragDepth = depth / frame.farDepth;
    SHOW_THING(THING_COLLIDER);
}
