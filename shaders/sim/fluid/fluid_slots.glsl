// Slots: all particles in the order of the cells of the fluids' grid, so that neighbours stand together. A slot's
// neighbours within sim.fluidListReach are listed once a step: of a fluid particle the fluid ones from the front of its
// list, solid ones from its end; of a solid particle the fluid ones.
#include "sim/common/fluid_living.glsl"
#include "sim/fluid/neighbour_lists.glsl"

uniform usamplerBuffer slotParticles;    // particle
uniform usamplerBuffer slotCounts;       // fluid neighbours, solid neighbours
uniform usamplerBuffer slotNeighbours;   // slots, sim/fluid/neighbour_lists.glsl

bool isFluid(uint particle)
{
    return particle >= sim.particleCount;
}

/// Four neighbours. Behind the last fluid one the slot itself stands.
uvec4 neighboursAt(uint texel)
{
    return texelFetch(slotNeighbours, int(texel));
}

uint solidNeighbour(uint slot, uint n)
{
    uint k = sim.fluidSlots - 1u - n;
    return neighboursAt(neighbourTexel(slot, k / 4u))[k % 4u];
}
