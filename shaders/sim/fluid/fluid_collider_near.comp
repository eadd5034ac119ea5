// One thread a slot: the colliders that its fluid particle may come near in this step, as bits: bit k for colliders k,
// k + 32, ...
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/common/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSearchPositions;
uniform samplerBuffer velocities;
BUFFER(uint, SlotColliders, slotColliders);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    vec3 x = texelFetch(fluidSearchPositions, int(i)).xyz;
    // The place is that of the middle of the step; half as much again for what changes on the way.
    float way = sim.lookAhead * sim.substepTime * length(texelFetch(velocities, int(i)).xyz);
    float reach = sim.fluidListReach + 1.5 * way;
    uint near = 0u;
    for (uint c = 0u; c < sim.colliderCount; ++c)
        near |= (colliderDistance(c, x).w < reach ? 1u : 0u) << (c & 31u);
    slotColliders[k] = isFluid(i) ? near : 0u;
}
