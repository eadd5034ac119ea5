// How much of the key light comes through fluid.
#include "render/common/fluid_looks.glsl"

uniform sampler2D fluidShadowPicture;
uniform sampler2D fluidFocusPicture;
uniform usamplerBuffer fluidMaterials;

// Part of the light that the surface turns away or spreads.
const float SURFACE_LOSS = 0.25;
// Of the slope of the surface, what rays are bent by: 1 - 1 / 1.333.
const float BENDING = 0.25;
const vec2 GATHERED = vec2(0.5, 2.5);   // least and most

/// The light on a plane behind a surface, over that without it: what it lit is as large as the determinant of how rays
/// that start beside each other move apart. @param way  From there [m].
float gathered(vec2 focus, float way)
{
    float a = BENDING * way, spread = 1.0 - a * focus.x + a * a * focus.y;
    return clamp(1.0 / max(abs(spread), 1e-3), GATHERED.x, GATHERED.y);
}

/// Behind the nearest fluid as the light sees it. Of several fluids the first one's colour is taken.
vec3 throughFluid(vec3 p)
{
    vec3 place = 0.5 * viewToLight(p) + 0.5;
    if (any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)))) return vec3(1.0);
    // Surfaces beyond the map's depth can be shaded, too, but not by the cleared map.
    vec4 gaps = min(place.z, 1.0) - textureGather(fluidShadowPicture, place.xy);
    vec2 between = fract(place.xy * vec2(textureSize(fluidShadowPicture, 0)) - 0.5);
    FluidLook look = fetchFluidLook(texelFetch(fluidMaterials, 0).x);
    vec3 absorption = look.absorption + 0.5 * look.scattering;
    vec2 focus = textureLod(fluidFocusPicture, place.xy, 0.0).rg;
    vec3 lit[4];
    for (int k = 0; k < 4; ++k) {
        float way = 2.0 * view.lightDepth.x * gaps[k] - frame.fluidRadius;
        lit[k] = way > 0.0 ? (1.0 - SURFACE_LOSS) * gathered(focus, way) * exp(-absorption * way) : vec3(1.0);
    }
    return mix(mix(lit[3], lit[2], between.x), mix(lit[0], lit[1], between.x), between.y);
}
