// One thread a fluid particle, those of pools in the order of their lists: parks it if it is in a drain, and notes who
// is parked for the next step. Drains stand behind the colliders.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_living.glsl"
#include "sim/fluid/emitters.glsl"
#include "sim/common/colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer poolOrder;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uint, PoolInactive, poolInactive);
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(uint, FluidTotals, totals);       // came, left

void main()
{
    uint thread = gl_GlobalInvocationID.x;
    if (thread >= sim.fluidFilled + sim.poolCapacity) return;
    bool pooled = thread >= sim.fluidFilled;
    uint place = thread - sim.fluidFilled, i = sim.particleCount + thread;
    if (pooled) i = texelFetch(poolOrder, int(orderAfter(stepsDone(counters[0].substep)) + place)).x;
    if (i == NO_PARTICLE) return;
    vec4 x = positions[i];
    bool parked = isInactive(x), drained = false;
    for (uint d = 0u; d < sim.drainCount; ++d)
        drained = drained || colliderDistance(sim.colliderCount + d, x.xyz).w < 0.0;
    if (drained && !parked) {
        positions[i].w = INACTIVE;
        velocities[i] = vec4(0);
        atomicAdd(totals[1], 1u);
    }
    if (pooled) poolInactive[place] = parked || drained ? 1u : 0u;
}
