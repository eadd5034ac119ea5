// One thread a stack: a Newton step of all its bodies at once, eliminated from the ends of its tree to its root.
// BEGINS, ENDS: the steps of an iteration. FIRST: those of a substep. AGAIN: of an iteration after the first.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/stack/stack_loads.glsl"
#include "sim/contact/stack/stack_loop_blocks.glsl"
#include "sim/contact/stack/stack_steps.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
READ_BUFFER(uvec4, StackSizes, stackSizes);
READ_BUFFER(uvec4, StackRanges, stackRanges);
#include "sim/contact/stack/stack_loops.glsl"

/// How far a motion is [rad and diameters].
float sizeOf(Motion motion)
{
    return length(motion.r) + length(motion.t) / sim.diameter;
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= stackSizes[STACKS_SIZE].w) return;
    uvec2 range = stackRanges[index].xy;
    uint loops = stackRanges[index].z;
    if (!inStack(stackOrder[range.x])) return;
#ifdef BEGINS
    for (uint k = range.x; k < range.y; ++k) note(stackOrder[k]);
#endif
    takeStep(range, loops);
    float size = 0.0;
    for (uint k = range.x; k < range.y; ++k) size = max(size, sizeOf(loadStep(stackOrder[k])));
    for (uint k = range.x; k < range.y; ++k) {
        if (size < MOST_STEP) move(stackOrder[k]);
        else giveUp(stackOrder[k]);
    }
}
