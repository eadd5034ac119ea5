// The colour of a body's shape, stored once or computed from its current speed: square roots in a number of 24 bits.
#include "render/common/frame_blocks.glsl"
#include "render/common/scale_color.glsl"
#include "render/common/surface.glsl"

#ifdef COLOR_BY_SPEED
uniform samplerBuffer velocities;

/// `stored`: y, z: two particles whose mean moves as the shape's middle does.
float shapeColor(vec3 stored)
{
    vec3 velocity = 0.5 * (texelFetch(velocities, int(stored.y)).xyz + texelFetch(velocities, int(stored.z)).xyz);
    return float(packAlbedo(scaleColor(length(velocity)), 0.0));
}
#else
float shapeColor(vec3 stored)
{
    return stored.x;
}
#endif
