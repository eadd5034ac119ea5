// One thread a chunk of cells: how many particles it holds.
#include "shared/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellCounts;
BUFFER(uint, ChunkSums, chunkSums);

void main()
{
    uint chunk = gl_GlobalInvocationID.x;
    if (chunk * CELLS_PER_CHUNK > step.cellMask) return;
    uint sum = 0u;
    for (uint k = 0u; k < CELLS_PER_CHUNK; ++k) sum += texelFetch(cellCounts, int(chunk * CELLS_PER_CHUNK + k)).x;
    chunkSums[chunk] = sum;
}
