// One thread a chunk of the pools' lists: moves its particles to their places in the list after this step. Inactive
// ones come first, and those that this step emits go to the end. If an emitter may take its oldest particles again,
// those become inactive.
#include "sim/common/kernel.glsl"
#include "sim/emitter/emitters.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer poolChunks;       // per chunk: emitter
uniform usamplerBuffer poolInactive;     // per entry of the list: 1 if its particle is inactive
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uint, PoolOrder, poolOrder);
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(uint, FluidTotals, totals);

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if ((chunk + 1u) * SCAN_CHUNK >= sim.poolCapacity) return;
    uint k = texelFetch(poolChunks, int(chunk)).x;
    uint start = emitters[k].poolStart, count = emitters[k].poolCount;
    EmitterState state = fetchEmitterState(k);
    uint before = inactiveBefore(chunk) - inactiveBefore(start / SCAN_CHUNK);
    uint steps = stepsDone(counters[0].substep), from = orderBefore(steps), to = orderAfter(steps);
    for (uint j = chunk * SCAN_CHUNK - start; j < min((chunk + 1u) * SCAN_CHUNK - start, count); ++j) {
        bool inactive = texelFetch(poolInactive, int(start + j)).x != 0u;
        // Its index if all inactive ones come first. The step takes the first `taken` of them.
        uint index = inactive ? before : state.inactive + (j - before);
        before += inactive ? 1u : 0u;
        uint particle = poolOrder[from + start + j];
        uint next = index < state.taken ? count - state.taken + index : index - state.taken;
        poolOrder[to + start + next] = particle;
        if (inactive || index >= state.inactive + state.retired) continue;
        DEACTIVATE(particle);
    }
}
