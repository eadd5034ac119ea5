// One thread a slot: the colliders that its particle may come near in this step, as bits: bit k for colliders k,
// k + 32, ...
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/common/contacts/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSearchPositions;
uniform samplerBuffer velocities;
#ifdef MOVING
uniform samplerBuffer colliderAheads;
#endif
BUFFER(uint, SlotColliders, slotColliders);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    vec3 x = texelFetch(fluidSearchPositions, int(i)).xyz;
    // Its position in the middle of the step; half of its path lies on each side, and may grow by half as much again.
    float halfPath = sim.lookAhead * sim.substepTime * length(texelFetch(velocities, int(i)).xyz);
    // Solids look for what they lie on, too.
    bool fluid = isFluid(i);
    float reach = (fluid ? sim.fluidReach : sim.fluidListReach) + 1.5 * halfPath;
    uint near = 0u;
    for (uint c = 0u; c < sim.colliderCount; ++c) {
        if (fluid && repeatsPlane(c)) continue;
        float ahead = 0.0;
#ifdef MOVING
        ahead = texelFetch(colliderAheads, int(c)).x;
#endif
        near |= (colliderSurface(c, x).distance < reach + ahead ? 1u : 0u) << (c & 31u);
    }
    slotColliders[k] = near;
}
