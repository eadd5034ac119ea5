// The colour of a vertex of cloth or of a soft body, or of its nearest particle's speed: square roots.
#include "render/common/frame_blocks.glsl"
#include "render/common/speed_color.glsl"
#include "render/common/surface.glsl"

#ifdef COLOR_BY_SPEED
uniform usamplerBuffer surfaceParticles;
uniform samplerBuffer velocities;

vec3 surfaceRoots(int vertex, float stored)
{
    int particle = int(texelFetch(surfaceParticles, vertex).x);
    return sqrt(speedColor(length(texelFetch(velocities, particle).xyz) / frame.speedScale));
}
#else
vec3 surfaceRoots(int vertex, float stored)
{
    return unpackRoots(uint(stored));
}
#endif
