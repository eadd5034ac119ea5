// One thread a chunk of values: their sum. The group that finishes last turns the sums into an exclusive prefix sum,
// each of its threads a part of them, so that no dispatch has to follow.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/scan.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer SCAN_VALUES;
layout(std430) coherent buffer SCAN_BLOCK { uint SCAN_SUMS[]; };   // the last: how many groups have finished
shared bool isLast;
shared uint partSums[GROUP_SIZE];

uint sumOfChunk(uint chunk)
{
    uint end = min((chunk + 1u) * SCAN_CHUNK, scanCount());
    uint sum = 0u;
    for (uint k = chunk * SCAN_CHUNK; k < end; ++k) sum += texelFetch(SCAN_VALUES, int(k)).x;
    return sum;
}

/// First and end of the chunks that a thread adds up.
uvec2 partOf(uint thread)
{
    uint each = (chunkCount() + GROUP_SIZE - 1u) / GROUP_SIZE;
    return min(each * uvec2(thread, thread + 1u), uvec2(chunkCount()));
}

uint sumOfPart(uvec2 part)
{
    uint sum = 0u;
    for (uint k = part.x; k < part.y; ++k) sum += SCAN_SUMS[k];
    return sum;
}

void addUp(uint thread, uvec2 part)
{
    uint sum = 0u;
    for (uint k = 0u; k < thread; ++k) sum += partSums[k];
    for (uint k = part.x; k < part.y; ++k) {
        uint value = SCAN_SUMS[k];
        SCAN_SUMS[k] = sum;
        sum += value;
    }
}

void main()
{
    uint chunk = gl_GlobalInvocationID.x, thread = gl_LocalInvocationIndex, finished = uint(SCAN_SUMS.length()) - 1u;
    if (chunk < chunkCount()) SCAN_SUMS[chunk] = sumOfChunk(chunk);
    memoryBarrierBuffer();
    barrier();
    if (thread == 0u) isLast = atomicAdd(SCAN_SUMS[finished], 1u) == gl_NumWorkGroups.x - 1u;
    barrier();
    memoryBarrierBuffer();
    uvec2 part = isLast ? partOf(thread) : uvec2(0);
    partSums[thread] = sumOfPart(part);
    barrier();
    if (isLast) addUp(thread, part);
    if (isLast && thread == 0u) SCAN_SUMS[finished] = 0u;
}
