// One thread a particle: its slot, cells in order and each cell by particle id, so that everything that is summed over
// neighbours is summed in one order.
#include "shared/kernel.glsl"
#include "shared/cell_rank.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidFoundPositions;
BUFFER(uint, SlotParticles, slotParticles);
BUFFER(vec4, FluidSorted, fluidSorted);  // w: bits of twice the slot, plus one if solid

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= gridParticles() || isNowhere(texelFetch(particleCells, int(i)).x)) return;
    uvec2 place = placeInCells(i);
    uint solid = i < step.particleCount ? 1u : 0u;
    // Away from the denormals that a GPU may flush and below the NaNs.
    vec4 sorted = vec4(texelFetch(fluidFoundPositions, int(i)).xyz, uintBitsToFloat(0x01000000u + 2u * place.x + solid));
    slotParticles[place.x] = i;
    fluidSorted[place.x] = sorted;
    if (place.y != NO_PLACE) fluidSorted[place.y] = sorted;
}
