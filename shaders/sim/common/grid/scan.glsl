// The values that a prefix sum runs over: the number of particles in each cell of the grid, or (LISTS) the number of
// contacts of each particle in the lists of contact_lists.glsl, or (POOLS) which particles of the pools' lists are
// inactive, or (FOAM) points of foam that each slot makes.
#include "sim/common/grid/fluid_grid.glsl"

#ifdef LISTS
#define SCAN_VALUES listCounts
#define SCAN_SUMS listSums
#define SCAN_BLOCK ListSums
uint scanCount() { return 3u * sim.particleCount; }
#elif defined(POOLS)
#define SCAN_VALUES poolInactive
#define SCAN_SUMS poolSums
#define SCAN_BLOCK PoolSums
uint scanCount() { return sim.poolCapacity; }
#elif defined(FOAM)
#define SCAN_VALUES foamBirths
#define SCAN_SUMS foamSums
#define SCAN_BLOCK FoamSums
uint scanCount() { return slotCount(); }
#else
#define SCAN_VALUES cellCounts
#define SCAN_SUMS cellSums
#define SCAN_BLOCK CellSums
uint scanCount() { return gridMask() + 1u; }
#endif

uint chunkCount()
{
    return (scanCount() + SCAN_CHUNK - 1u) / SCAN_CHUNK;
}
