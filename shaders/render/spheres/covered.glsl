// Particles that are drawn as spheres: active ones that are not hidden and that no skin covers.
#include "render/common/sphere_sizes.glsl"

#ifdef COVERED
uniform usamplerBuffer coveredParticles;    // a bit each

bool isShown(uint particle, vec4 position)
{
    uint bits = texelFetch(coveredParticles, int(particle >> 5)).x;
    return isThere(position) && (bits >> (particle & 31u) & 1u) == 0u;
}
#else
bool isShown(uint particle, vec4 position)
{
    return isThere(position);
}
#endif
