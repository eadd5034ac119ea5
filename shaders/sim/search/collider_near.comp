// One thread a mover: the colliders that any of its particles may touch, as bits: bit k for colliders k, k + 32, ...
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/colliders.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/common/contacts/touch.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchCentres;
BUFFER(uint, MoverColliders, moverColliders);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    float radius = moverRadius(m);
    SearchCentre found = fetchSearchCentre(searchCentres, m);
    float reach = colliderReach(radiusExcess(m)) + radius + max(extraMargin(found), 0.0);
    uint near = 0u;
    for (uint c = 0u; c < sim.colliderCount; ++c)
        near |= (colliderBound(c, found.position) < reach ? 1u : 0u) << (c & 31u);
    moverColliders[m] = near;
}
