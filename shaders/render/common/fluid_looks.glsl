// How fluids look, by material.

uniform samplerBuffer fluidLooks;   // two texels each

struct FluidLook {
    vec3 absorption;   // [1/m]
    float scattering;  // [1/m]
    vec3 color;        // of the light that comes back
    float emission;
};

FluidLook fetchFluidLook(uint material)
{
    vec4 a = texelFetch(fluidLooks, int(2u * material)), b = texelFetch(fluidLooks, int(2u * material + 1u));
    return FluidLook(a.xyz, a.w, b.xyz, b.w);
}
