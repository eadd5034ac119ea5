// The colour word of a body's shape: stored once, or computed from its current speed.
#include "render/common/frame_blocks.glsl"
#include "render/common/speed_color.glsl"
#include "render/common/surface.glsl"

#ifdef COLOR_BY_SPEED
uniform samplerBuffer velocities;

/// `stored`: y, z: two particles whose mean moves as the shape's middle does.
uint shapeColor(vec3 stored)
{
    vec3 velocity = 0.5 * (texelFetch(velocities, int(stored.y)).xyz + texelFetch(velocities, int(stored.z)).xyz);
    return packAlbedo(speedColor(length(velocity) / frame.speedScale), 1.0);
}
#else
uint shapeColor(vec3 stored)
{
    return packRoots(unpackRoots(uint(stored.x)), 1.0);
}
#endif
