// A particle's colour word: stored once, or computed from its current speed or another quantity.
#include "render/common/frame_blocks.glsl"
#include "render/common/scale_color.glsl"
#include "render/common/surface.glsl"

uniform usamplerBuffer sphereColors;
#ifdef COLOR_BY_SPEED
uniform samplerBuffer velocities;
#endif

#if defined(COLOR_BY_SPEED) || defined(COLOR_BY_QUANTITY)
vec3 movingColor(int particle)
{
#ifdef COLOR_BY_QUANTITY
    return quantityColor(particle);
#else
    return scaleColor(length(texelFetch(velocities, particle).xyz));
#endif
}

uint sphereColor(int particle)
{
    // A stored colour is that of a highlighted joint.
    uint stored = texelFetch(sphereColors, particle).x, finish = stored >> 24;
    uint moving = packAlbedo(movingColor(particle), 1.0);
    if (finish != 0u) moving = (moving & 0xffffffu) | finish << 24;
    return (stored & 0xffffffu) != 0u ? stored : moving;
}
#else
uint sphereColor(int particle)
{
    return texelFetch(sphereColors, particle).x;
}
#endif
