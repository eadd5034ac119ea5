// FLUIDS: the same passes over the neighbour grid of fluids, which holds all active particles. It is always a lattice,
// and finer along x. The host gives these kernels that grid's buffers.

#ifdef FLUIDS
#undef GRID_HASH
#include "sim/common/grid/fluid_living.glsl"
uint gridParticles() { return slotCapacity(); }
uint gridMembers() { return slotCount(); }
uint gridMask() { return sim.fluidCellMask; }
uvec2 gridStrides() { return uvec2(sim.fluidStrideY, sim.fluidStrideZ); }
vec3 inverseGridCell() { return sim.inverseFluidCell * vec3(FINE_CELLS, 1, 1); }
#define CELLS_ALONG FINE_CELLS
#else
uint gridParticles() { return sim.particleCount; }
uint gridMembers() { return sim.particleCount; }
bool isInactive(vec4 place) { return false; }
uint gridMask() { return sim.cellMask; }
uvec2 gridStrides() { return uvec2(sim.cellStrideY, sim.cellStrideZ); }
vec3 inverseGridCell() { return vec3(sim.inverseCellSize); }
#define CELLS_ALONG 1
#endif

// Whether a particle is in no cell, according to grid_count.
#if defined(FLUIDS) && defined(POOL)
bool isNowhere(uint cell) { return cell == NONE; }
#else
bool isNowhere(uint cell) { return false; }
#endif
