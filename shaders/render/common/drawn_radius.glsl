// How large a sphere is drawn: grains have sizes of their own.
#include "render/common/sphere_sizes.glsl"

uniform samplerBuffer sphereScales;

float drawnRadius(uint particle)
{
    float radius = sphereRadius(particle) * texelFetch(sphereScales, int(particle)).x;
#ifdef BEADS
    // frame.fluidRadius is that of surfaces.
    radius *= FLUID_RADIUS / SURFACE_RADIUS;
#endif
    return radius;
}
