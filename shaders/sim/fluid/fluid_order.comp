// One thread a particle: its slot. Slots are in the order of cells, and within a cell of particle ids, so that all sums
// over neighbours have one order.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/cell_rank.glsl"
#include "sim/common/fluid_particles.glsl"
#include "sim/fluid/packed_positions.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSearchPositions;
BUFFER(uint, SlotParticles, slotParticles);
BUFFER(uint, ParticleSlots, particleSlots);
BUFFER(uint, FluidSorted, fluidSorted);  // packed

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= gridParticles() || isNowhere(texelFetch(particleCells, int(i)).x)) return;
    uvec2 indices = placeInCells(i);
    uint code = packPosition(texelFetch(fluidSearchPositions, int(i)).xyz, !isFluid(i));
    slotParticles[indices.x] = i;
    particleSlots[i] = indices.x;
    fluidSorted[indices.x] = code;
    if (indices.y != NONE) fluidSorted[indices.y] = code;
}
