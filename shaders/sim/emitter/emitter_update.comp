// One thread: what each emitter does in this step, which depends on the number of the step alone: how many layers are
// due, and how many particles they take from its pool. Time in layers is a 64-bit integer of 2^-32 layers, so that no
// layer is late or lost.
#include "sim/common/kernel.glsl"
#include "sim/emitter/emitters.glsl"
#include "sim/common/groups.glsl"

layout(local_size_x = 1) in;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(EmitterState, EmitterStates, newStates);
BUFFER(uvec4, Dispatches, dispatches);

/// Layers since the first, whole and in 2^-32. Before the first: layer -1.
uvec2 layerTime(Emitter e, uint steps)
{
    if (steps < e.startStep) return uvec2(-1, 0);
    // 64-bit numbers, low half first.
    uvec2 atStart = e.clock.xy, perStep = e.clock.zw;
    uint high, low, carry;
    umulExtended(steps - e.startStep, perStep.x, high, low);
    low = uaddCarry(low, atStart.x, carry);
    return uvec2(high + (steps - e.startStep) * perStep.y + atStart.y + carry, low);
}

/// How many layers have left after so many steps.
uint layersAt(Emitter e, uint steps)
{
    return min(layerTime(e, steps).x + 1u, e.layerLimit);
}

void main()
{
    uint steps = stepsDone(counters[0].substep), candidates = 0u;
    for (uint k = 0u; k < uint(emitters.length()); ++k) {
        Emitter e = emitters[k];
        uint chunk = e.poolStart / SCAN_CHUNK, chunks = (e.poolCount + SCAN_CHUNK - 1u) / SCAN_CHUNK;
        uint inactive = inactiveBefore(chunk + chunks) - inactiveBefore(chunk);
        uvec2 now = layerTime(e, steps);
        uint layers = layersAt(e, steps), due = layers - layersAt(e, steps - 1u);
        EmitterState state;
        // A layer needs all of its particles; an incomplete one is left out.
        state.taken = min(due, inactive / e.pointCount) * e.pointCount;
        uint left = inactive - state.taken, wanted = (layersAt(e, steps + 1u) - layers) * e.pointCount;
        state.retired = e.takesOldest != 0u ? min(max(wanted, left) - left, e.poolCount - inactive) : 0u;
        state.inactive = inactive;
        state.firstCandidate = candidates;
        state.age = (float(now.x - (layers - 1u)) + float(now.y) * exp2(-32.0)) * e.interval;
        newStates[k] = state;
        candidates += state.taken;
    }
    dispatches[DISPATCH_EMIT] = uvec4(groups(candidates), 1, 1, 0);
    dispatches[DISPATCH_SLOTS] = uvec4(groups(slotCount() + candidates), 1, 1, 0);
}
