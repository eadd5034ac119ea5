// How much of the key light comes through fluid.
#include "render/common/frame_blocks.glsl"

uniform sampler2D fluidShadowPicture;
uniform sampler2D fluidFocusPicture;
uniform sampler2D fluidDimsPicture;

// Part of the light that the surface turns away or spreads.
const float SURFACE_LOSS = 0.25;
// Of the slope of the surface, what rays are bent by: 1 - 1 / 1.333.
const float BENDING = 0.25;
const vec2 GATHERED = vec2(0.5, 2.5);   // least and most

/// The light on a plane behind a surface, over that without it: what it lit is as large as the determinant of how rays
/// that start beside each other move apart. Far behind a focus light does not stay at its place, nor is its pattern
/// known. @param way  From there [m].
float gathered(vec2 focus, float way)
{
    float a = BENDING * way, spread = 1.0 - a * focus.x + a * a * focus.y;
    float far = 0.5 * a * focus.x, known = 1.0 / (1.0 + far * far * far * far);
    return mix(1.0, clamp(1.0 / max(abs(spread), 1e-3), GATHERED.x, GATHERED.y), known);
}

/// Behind the nearest fluid as the light sees it, of which no more counts than has been gone through.
vec3 throughFluid(vec3 p)
{
    vec3 place = 0.5 * viewToLight(p) + 0.5;
    if (any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)))) return vec3(1.0);
    // Surfaces beyond the map's depth can be shaded, too, but not by the cleared map.
    vec4 gaps = min(place.z, 1.0) - textureGather(fluidShadowPicture, place.xy);
    vec2 between = fract(place.xy * vec2(textureSize(fluidShadowPicture, 0)) - 0.5);
    vec4 dims = textureLod(fluidDimsPicture, place.xy, 0.0);
    vec2 focus = textureLod(fluidFocusPicture, place.xy, 0.0).rg;
    float most = 2.0 * view.lightDepth.x * max(max(gaps.x, gaps.y), max(gaps.z, gaps.w)) - frame.fluidRadius;
    vec3 left = (1.0 - SURFACE_LOSS) * exp(-dims.rgb * clamp(most / max(dims.a, 1e-4), 0.0, 1.0)), lit[4];
    for (int k = 0; k < 4; ++k) {
        float way = 2.0 * view.lightDepth.x * gaps[k] - frame.fluidRadius;
        lit[k] = way > 0.0 ? gathered(focus, way) * left : vec3(1.0);
    }
    return mix(mix(lit[3], lit[2], between.x), mix(lit[0], lit[1], between.x), between.y);
}
