// How fluids look, by material.
#include "shared/draw_types.h"

uniform samplerBuffer fluidLooks;   // two texels each

struct FluidLook {
    vec3 absorption;   // [1/m]
    float scattering;  // [1/m]
    vec3 color;        // of the light that comes back
    float emission;
};

/// @param material  NO_SURFACE: that of the first.
FluidLook fetchFluidLook(uint material)
{
    if (material == NO_SURFACE) material = 0u;
    vec4 a = texelFetch(fluidLooks, int(2u * material)), b = texelFetch(fluidLooks, int(2u * material + 1u));
    return FluidLook(a.xyz, a.w, b.xyz, b.w);
}
