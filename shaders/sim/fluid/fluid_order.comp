// One thread a particle: its slot, cells in order and each cell by particle id, so that everything that is summed over
// neighbours is summed in one order.
#include "sim/common/kernel.glsl"
#include "sim/common/cell_rank.glsl"
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
    if (place.y != NO_PLACE) fluidSorted[place.y] = code;
}
