// One thread a particle: its slot. Slots are in the order of cells, and within a cell of particle ids, so that all sums
// over neighbours have one order.
#include "sim/common/kernel.glsl"
#include "sim/common/cell_rank.glsl"
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
    uvec2 place = placeInCells(i);
    uint code = packPosition(texelFetch(fluidSearchPositions, int(i)).xyz, i < sim.particleCount);
    slotParticles[place.x] = i;
    particleSlots[i] = place.x;
    fluidSorted[place.x] = code;
    if (place.y != NONE) fluidSorted[place.y] = code;
}
