// Slots: all particles in the order of the cells of the fluids' grid, so that neighbours stand together. A slot's
// neighbours within step.fluidListReach are listed once a step: of a fluid particle the fluid ones from the front of its
// list, solid ones from its end; of a solid particle the fluid ones.
#include "shared/fluid_living.glsl"

uniform usamplerBuffer slotParticles;    // particle
uniform usamplerBuffer slotCounts;       // fluid neighbours, solid neighbours
uniform usamplerBuffer slotNeighbours;   // slots

bool isFluid(uint particle)
{
    return particle >= step.particleCount;
}

int neighbourPlace(uint slot, uint n)
{
    return int(n * slotCapacity() + slot);
}

uint fluidNeighbour(uint slot, uint n)
{
    return texelFetch(slotNeighbours, neighbourPlace(slot, n)).x;
}

uint solidNeighbour(uint slot, uint n)
{
    return fluidNeighbour(slot, step.fluidSlots - 1u - n);
}
