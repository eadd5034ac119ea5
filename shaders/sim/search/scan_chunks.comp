// One thread: the exclusive prefix sum of the chunks, in place.
#include "sim/common/kernel.glsl"
#include "sim/search/scan.glsl"

layout(local_size_x = 1) in;
BUFFER(uint, SCAN_BLOCK, SCAN_SUMS);

void main()
{
    uint sum = 0u;
    for (uint k = 0u; k < chunkCount(); ++k) {
        uint value = SCAN_SUMS[k];
        SCAN_SUMS[k] = sum;
        sum += value;
    }
}
