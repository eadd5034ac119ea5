// One thread: the exclusive prefix sum of the chunks, in place.
#include "shared/kernel.glsl"

layout(local_size_x = 1) in;
BUFFER(uint, ChunkSums, chunkSums);

void main()
{
    uint chunks = (step.cellMask + 1u) / CELLS_PER_CHUNK;
    uint sum = 0u;
    for (uint k = 0u; k < chunks; ++k) {
        uint count = chunkSums[k];
        chunkSums[k] = sum;
        sum += count;
    }
}
