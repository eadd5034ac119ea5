// One thread a fluid particle, those of pools in the order of their lists: makes it inactive if it is in a drain, and
// notes inactive particles for the next step. Drains are stored after the colliders.
#include "sim/common/kernel.glsl"
#include "sim/emitter/emitters.glsl"
#include "sim/common/contacts/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer poolOrder;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uint, PoolInactive, poolInactive);
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(uint, FluidTotals, totals);

void main()
{
    uint thread = gl_GlobalInvocationID.x;
    if (thread >= sim.fluidFilled + sim.poolCapacity) return;
    bool pooled = thread >= sim.fluidFilled;
    uint index = thread - sim.fluidFilled, i = sim.particleCount + thread;
    if (pooled) i = texelFetch(poolOrder, int(orderAfter(stepsDone(counters[0].substep)) + index)).x;
    if (i == NONE) return;
    FluidPosition own = fluidPosition(positions[i]);
    bool drained = false;
    for (uint d = 0u; d < sim.drainCount; ++d)
        drained = drained || colliderSurface(sim.colliderCount + d, own.position).distance < 0.0;
    if (drained && !own.inactive) {
        DEACTIVATE(i);
    }
    if (pooled) poolInactive[index] = own.inactive || drained ? 1u : 0u;
}
