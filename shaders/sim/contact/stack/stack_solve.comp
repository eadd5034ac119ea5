// One thread a stack: a Newton step of all its bodies at once, eliminated from the ends of its tree to its root.
// stack_move takes it: apart, since this is by far the longest kernel to compile, and is compiled once.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/stack/stack_loads.glsl"
#include "sim/contact/stack/stack_loop_blocks.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
#include "sim/contact/stack/stack_ranges.glsl"
#include "sim/contact/stack/stack_loops.glsl"

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (!isSolved(index)) return;
    takeStep(stackRanges[index].xy, stackRanges[index].z);
}
