// One thread: how many work groups contact_find_far needs.
#include "shared/kernel.glsl"

layout(local_size_x = 1) in;
BUFFER(uvec4, Dispatches, dispatches);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    dispatches[DISPATCH_FAST] = uvec4((counters[0].fastListed + GROUP_SIZE - 1u) / GROUP_SIZE, 1, 1, 0);
}
