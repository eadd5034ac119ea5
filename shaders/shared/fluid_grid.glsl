// FLUIDS: the same passes over the neighbour grid of fluids, which holds all particles but those that are parked.
#define NO_CELL 0xffffffffu

#ifdef FLUIDS
#include "shared/fluid_living.glsl"
#define cellCounts fluidCellCounts
#define CellCounts FluidCellCounts
#define cellSums fluidCellSums
#define CellSums FluidCellSums
#define cellStarts fluidCellStarts
#define CellStarts FluidCellStarts
#define cellMembers fluidCellMembers
#define CellMembers FluidCellMembers
#define particleCells fluidParticleCells
#define ParticleCells FluidParticleCells
#define foundPositions fluidFoundPositions
uint gridParticles() { return slotCapacity(); }
uint gridMembers() { return slotCount(); }
float inverseGridCell() { return step.inverseFluidCell; }
#else
uint gridParticles() { return step.particleCount; }
uint gridMembers() { return step.particleCount; }
bool isParked(vec4 place) { return false; }
float inverseGridCell() { return step.inverseCellSize; }
#endif

// Whether a particle is in no cell, by what grid_count wrote of it.
#if defined(FLUIDS) && defined(POOL)
bool isNowhere(uint cell) { return cell == NO_CELL; }
#else
bool isNowhere(uint cell) { return false; }
#endif
