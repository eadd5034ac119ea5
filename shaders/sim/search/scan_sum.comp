// One thread a chunk of values: their sum.
#include "sim/common/kernel.glsl"
#include "sim/search/scan.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer SCAN_VALUES;
BUFFER(uint, SCAN_BLOCK, SCAN_SUMS);

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if (chunk >= chunkCount()) return;
    uint end = min((chunk + 1u) * SCAN_CHUNK, scanCount());
    uint sum = 0u;
    for (uint k = chunk * SCAN_CHUNK; k < end; ++k) sum += texelFetch(SCAN_VALUES, int(k)).x;
    SCAN_SUMS[chunk] = sum;
}
