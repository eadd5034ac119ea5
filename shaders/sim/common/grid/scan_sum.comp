// One thread a chunk of values: their sum. The group that finishes last turns the sums into an exclusive prefix sum, so
// that no dispatch of one thread has to follow.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/scan.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer SCAN_VALUES;
layout(std430) coherent buffer SCAN_BLOCK { uint SCAN_SUMS[]; };   // the last: how many groups have finished
shared bool isLast;

uint sumOfChunk(uint chunk)
{
    uint end = min((chunk + 1u) * SCAN_CHUNK, scanCount());
    uint sum = 0u;
    for (uint k = chunk * SCAN_CHUNK; k < end; ++k) sum += texelFetch(SCAN_VALUES, int(k)).x;
    return sum;
}

void addUp()
{
    uint sum = 0u;
    for (uint k = 0u; k < chunkCount(); ++k) {
        uint value = SCAN_SUMS[k];
        SCAN_SUMS[k] = sum;
        sum += value;
    }
}

void main()
{
    uint chunk = gl_GlobalInvocationID.x, finished = uint(SCAN_SUMS.length()) - 1u;
    if (chunk < chunkCount()) SCAN_SUMS[chunk] = sumOfChunk(chunk);
    memoryBarrierBuffer();
    barrier();
    if (gl_LocalInvocationIndex == 0u) isLast = atomicAdd(SCAN_SUMS[finished], 1u) == gl_NumWorkGroups.x - 1u;
    barrier();
    if (!isLast || gl_LocalInvocationIndex != 0u) return;
    memoryBarrierBuffer();
    addUp();
    SCAN_SUMS[finished] = 0u;
}
