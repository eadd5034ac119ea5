// One thread a chunk of counts: where each particle's contacts start in the lists. The first sets how many work groups
// the candidates take.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/scan.glsl"
#include "sim/common/groups.glsl"
#include "sim/common/contacts/contact_lists.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer listCounts;
uniform usamplerBuffer listSums;
BUFFER(uint, ListStarts, listStarts);
BUFFER(uvec4, Dispatches, dispatches);
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if (chunk >= chunkCount()) return;
    uint candidates = min(counters[0].candidateCount, sim.candidateCapacity);
    if (chunk == 0u) dispatches[DISPATCH_CANDIDATES] = uvec4(groups(max(candidates, 1u)), 1, 1, 0);
    uint first = listStart(counters[0].listParity, 0u);
    uint end = min((chunk + 1u) * SCAN_CHUNK, scanCount());
    uint sum = texelFetch(listSums, int(chunk)).x;
    for (uint k = chunk * SCAN_CHUNK; k < end; ++k) {
        listStarts[first + k] = sum;
        sum += texelFetch(listCounts, int(k)).x;
    }
    if (end == scanCount()) listStarts[first + end] = sum;
}
