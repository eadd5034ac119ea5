// One thread: counts the substep and sets the sizes of the dispatches that find contact candidates, to zero if nothing
// has used up its margin, or nothing could answer to a contact.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"

layout(local_size_x = 1) in;
BUFFER(Counters, CountersBlock, counters);
BUFFER(uvec4, Dispatches, dispatches);

void main()
{
    bool freeMoved = sim.animatedCount == 0u || counters[0].freeMoved != 0u;
    bool due = (counters[0].due != 0u && freeMoved) || counters[0].substep == 0u;
    uint on = due ? 1u : 0u;
    dispatches[DISPATCH_PARTICLES] = uvec4(on * groups(sim.particleCount), 1, 1, 0);
    dispatches[DISPATCH_CELL_CHUNKS] = uvec4(on * groups((sim.cellMask + 1u) / SCAN_CHUNK), 1, 1, 0);
    dispatches[DISPATCH_LIST_CHUNKS] = uvec4(on * groups(3u * sim.particleCount / SCAN_CHUNK + 1u), 1, 1, 0);
    dispatches[DISPATCH_MOVERS] = uvec4(on * groups(sim.moverCount), 1, 1, 0);
    dispatches[DISPATCH_NEW_PAIRS] = dispatches[DISPATCH_NEW_COLLIDER_PAIRS] = dispatches[DISPATCH_FAST] =
        dispatches[DISPATCH_CANDIDATES] = uvec4(0, 1, 1, 0);
    if (due) {
        counters[0].farSighted = counters[0].fastLater <= sim.fastLimit ? 1u : 0u;
        counters[0].fastLater = 0u;
    }
    counters[0].fastCount = counters[0].fastListed = counters[0].candidateCount = 0u;
    counters[0].due = counters[0].freeMoved = 0u;
    counters[0].substep += 1u;
    counters[0].searchCount += on;
    counters[0].listParity ^= on;
}
