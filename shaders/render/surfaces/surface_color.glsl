// The colour of a vertex of cloth or of a soft body, or that of a quantity of its nearest particle: square roots.
#include "render/common/frame_blocks.glsl"
#include "render/common/scale_color.glsl"
#include "render/common/surface.glsl"

#if defined(COLOR_BY_QUANTITY) || defined(COLOR_BY_SPEED) || defined(LAYERS)
uniform usamplerBuffer surfaceParticles;    // the nearest one
#endif

#ifdef COLOR_BY_QUANTITY
vec3 surfaceRoots(int vertex, float stored)
{
    return sqrt(quantityColor(int(texelFetch(surfaceParticles, vertex).x)));
}
#elif defined(COLOR_BY_SPEED)
uniform samplerBuffer velocities;

vec3 surfaceRoots(int vertex, float stored)
{
    int particle = int(texelFetch(surfaceParticles, vertex).x);
    return sqrt(scaleColor(length(texelFetch(velocities, particle).xyz)));
}
#else
vec3 surfaceRoots(int vertex, float stored)
{
    return unpackRoots(uint(stored));
}
#endif
