// One thread: counts the substep and sets the sizes of the dispatches that find contact candidates, to zero where
// nobody has used up its margin.
#include "shared/kernel.glsl"

layout(local_size_x = 1) in;
BUFFER(Counters, CountersBlock, counters);
BUFFER(uvec4, Dispatches, dispatches);   // groups for: particles, cells, chunks of cells, one thread

uint groups(uint threads)
{
    return (threads + GROUP_SIZE - 1u) / GROUP_SIZE;
}

void main()
{
    bool due = counters[0].due != 0u || counters[0].substep == 0u || step.alwaysFind == 1u;
    uint on = due ? 1u : 0u;
    uint cells = step.cellMask + 1u;
    dispatches[0] = uvec4(on * groups(step.particleCount), 1, 1, 0);
    dispatches[1] = uvec4(on * groups(cells), 1, 1, 0);
    dispatches[2] = uvec4(on * groups(cells / CELLS_PER_CHUNK), 1, 1, 0);
    dispatches[3] = uvec4(on, 1, 1, 0);
    counters[0].due = 0u;
    counters[0].substep += 1u;
    counters[0].findCount += on;
    counters[0].listParity ^= on;
}
