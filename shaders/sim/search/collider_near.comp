// One thread a mover: the colliders that any of its particles may touch, as bits: bit k for colliders k, k + 32, ...
#include "sim/common/kernel.glsl"
#include "sim/common/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchCentres;      // w: how far it may drift
uniform samplerBuffer bodyMoments;       // w of the first of three: radius
BUFFER(uint, MoverColliders, moverColliders);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    float radius = m < sim.bodyCount ? texelFetch(bodyMoments, int(3u * m)).w : 0.0;
    vec4 found = texelFetch(searchCentres, int(m));
    float reach = sim.contactRadius - 0.5 * sim.diameter + radius + max(found.w - sim.drift, 0.0);
    uint near = 0u;
    for (uint c = 0u; c < sim.colliderCount; ++c)
        near |= (colliderBound(c, found.xyz) < reach ? 1u : 0u) << (c & 31u);
    moverColliders[m] = near;
}
