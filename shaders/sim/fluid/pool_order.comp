// One thread a chunk of the pools' lists: moves its particles to where they stand in the list after this step. The
// parked come first, those that this step emits go to the end, and where the oldest are taken again they are parked.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_living.glsl"
#include "sim/fluid/emitters.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer poolChunks;       // per chunk: emitter
uniform usamplerBuffer poolSums;         // per chunk: parked particles before it
uniform usamplerBuffer poolInactive;       // per place: 1 if its particle is parked
uniform usamplerBuffer emitterStates;    // two texels each
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uint, PoolOrder, poolOrder);
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(uint, FluidTotals, totals);       // came, left

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if ((chunk + 1u) * SCAN_CHUNK >= sim.poolCapacity) return;
    uint k = texelFetch(poolChunks, int(chunk)).x;
    uint start = emitters[k].poolStart, count = emitters[k].poolCount;
    uvec4 state = texelFetch(emitterStates, int(2u * k));
    uint taken = state.x, retired = state.y, parked = state.z;
    uint before = texelFetch(poolSums, int(chunk)).x - texelFetch(poolSums, int(start / SCAN_CHUNK)).x;
    uint steps = stepsDone(counters[0].substep), from = orderBefore(steps), to = orderAfter(steps);
    for (uint j = chunk * SCAN_CHUNK - start; j < min((chunk + 1u) * SCAN_CHUNK - start, count); ++j) {
        bool isInactive = texelFetch(poolInactive, int(start + j)).x != 0u;
        uint place = isInactive ? before : parked + (j - before);
        before += isInactive ? 1u : 0u;
        uint particle = poolOrder[from + start + j];
        poolOrder[to + start + (place < taken ? count - taken + place : place - taken)] = particle;
        if (isInactive || place >= parked + retired) continue;
        positions[particle].w = INACTIVE;
        velocities[particle] = vec4(0);
        atomicAdd(totals[1], 1u);
    }
}
