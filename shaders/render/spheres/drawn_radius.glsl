// How large a sphere is drawn: grains have sizes of their own.
#include "render/common/sphere_sizes.glsl"

uniform samplerBuffer sphereScales;

float drawnRadius(uint particle)
{
    return sphereRadius(particle) * texelFetch(sphereScales, int(particle)).x;
}
