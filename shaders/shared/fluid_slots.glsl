// Slots: all particles in the order of the cells of the fluids' grid, so that neighbours stand together. A slot's
// neighbours within step.fluidListReach are listed once a step: of a fluid particle the fluid ones from the front of its
// list, solid ones from its end; of a solid particle the fluid ones.
#include "shared/fluid_living.glsl"
#include "shared/neighbour_lists.glsl"

uniform usamplerBuffer slotParticles;    // particle
uniform usamplerBuffer slotCounts;       // fluid neighbours, solid neighbours
uniform usamplerBuffer slotNeighbours;   // slots, shared/neighbour_lists.glsl

bool isFluid(uint particle)
{
    return particle >= step.particleCount;
}

/// Neighbours n .. n + 3, n a multiple of four. Behind the last fluid one the slot itself stands.
uvec4 fourNeighbours(uint slot, uint n)
{
    return texelFetch(slotNeighbours, int(neighbourTexel(slot, n / 4u)));
}

uint solidNeighbour(uint slot, uint n)
{
    uint k = step.fluidSlots - 1u - n;
    return fourNeighbours(slot, k)[k % 4u];
}
