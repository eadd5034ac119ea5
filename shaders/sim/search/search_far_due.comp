// One thread: how many work groups contact_find_far needs.
#include "sim/common/kernel.glsl"
#include "sim/common/groups.glsl"

layout(local_size_x = 1) in;
BUFFER(uvec4, Dispatches, dispatches);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    dispatches[DISPATCH_FAST] = uvec4(groups(counters[0].fastListed), 1, 1, 0);
}
