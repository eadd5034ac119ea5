// How much of the key light comes through fluid.
#include "render/common/fluid_looks.glsl"

uniform sampler2D fluidShadowPicture;
uniform usamplerBuffer fluidMaterials;

// Part of the light that the surface turns away or spreads.
const float SURFACE_LOSS = 0.25;

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
    vec3 lit[4];
    for (int k = 0; k < 4; ++k) {
        float way = 2.0 * view.lightDepth.x * gaps[k] - frame.fluidRadius;
        lit[k] = way > 0.0 ? (1.0 - SURFACE_LOSS) * exp(-absorption * way) : vec3(1.0);
    }
    return mix(mix(lit[3], lit[2], between.x), mix(lit[0], lit[1], between.x), between.y);
}
