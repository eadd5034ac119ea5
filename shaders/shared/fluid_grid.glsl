// FLUIDS: the same passes over the neighbour grid of fluids, which holds all particles.
#ifdef FLUIDS
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
uint gridParticles() { return step.particleCount + step.fluidCount; }
float inverseGridCell() { return step.inverseFluidCell; }
#else
uint gridParticles() { return step.particleCount; }
float inverseGridCell() { return step.inverseCellSize; }
#endif
