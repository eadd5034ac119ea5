// Which values a prefix sum is over: how many particles each cell of the grid holds, or (LISTS) how many contacts each
// particle has in the lists of contact_lists.glsl.

#include "shared/fluid_grid.glsl"

#ifdef LISTS
#define SCAN_VALUES listCounts
#define SCAN_SUMS listSums
#define SCAN_BLOCK ListSums
uint scanCount() { return 3u * step.particleCount; }
#else
#define SCAN_VALUES cellCounts
#define SCAN_SUMS cellSums
#define SCAN_BLOCK CellSums
uint scanCount() { return step.cellMask + 1u; }
#endif

uint chunkCount()
{
    return (scanCount() + SCAN_CHUNK - 1u) / SCAN_CHUNK;
}
