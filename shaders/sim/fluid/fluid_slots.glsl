// Slots: all particles in the order of the cells of the fluids' grid, so that neighbours stand together. A slot's
// neighbours within sim.fluidListReach are listed once a step. A fluid particle's list has fluid neighbours from its
// front on and solid ones from its end on; a solid particle's list has fluid neighbours only.
// A kernel that stores into a buffer with a sampler here calls its block new...
#include "sim/common/fluid_particles.glsl"

uniform usamplerBuffer slotParticles;
uniform usamplerBuffer particleSlots;
uniform usamplerBuffer slotCounts;
uniform usamplerBuffer slotNeighbours;

/// The particle in a slot.
uint fetchSlotParticle(uint slot)
{
    return texelFetch(slotParticles, int(slot)).x;
}

/// The slot of a particle.
uint fetchParticleSlot(uint particle)
{
    return texelFetch(particleSlots, int(particle)).x;
}

/// The number of neighbours that a slot lists.
struct NeighbourCounts {
    uint fluids, solids;
};

NeighbourCounts fetchCounts(uint slot)
{
    uvec2 t = texelFetch(slotCounts, int(slot)).xy;
    return NeighbourCounts(t.x, t.y);
}

uvec2 pack(NeighbourCounts counts)
{
    return uvec2(counts.fluids, counts.solids);
}

/// The same for forces between or on fluid particles: zero in the slot of a solid particle.
NeighbourCounts fetchFluidCounts(uint slot, uint particle)
{
    return isFluid(particle) ? fetchCounts(slot) : NeighbourCounts(0u, 0u);
}

// Lists of neighbours have four slots in a texel. Texels of NEIGHBOUR_BLOCK slots are interleaved, so that threads that
// read their lists together read memory in order.

/// The texel of a slot's neighbours 4 four .. 4 four + 3. The next four are NEIGHBOUR_BLOCK texels further.
uint neighbourTexel(uint slot, uint four)
{
    return (slot / NEIGHBOUR_BLOCK * (sim.fluidSlots / 4u) + four) * NEIGHBOUR_BLOCK + slot % NEIGHBOUR_BLOCK;
}

/// Four fluid neighbours. After the last one, or if there are none, the slot itself is listed.
uvec4 fetchNeighbours(uint texel)
{
    return texelFetch(slotNeighbours, int(texel));
}

/// How many entries the fluid neighbours of a list take: whole texels, at least one.
uint paddedCount(uint count)
{
    return max(count + 3u & ~3u, 4u);
}

/// How often the slot itself is listed.
uint paddingOf(uint count)
{
    return paddedCount(count) - count;
}

/// Walks over a slot's fluid neighbours, four at a time, at least once: `do ... texels.slots ... while
/// (nextTexel(texels))`. A software driver runs a loop that asks before its rounds once more than needed. The next four
/// are fetched while these are used.
struct NeighbourTexels {
    uvec4 slots, next;
    uint now, end;
};

NeighbourTexels neighbourTexels(uint slot, uint count)
{
    uint first = neighbourTexel(slot, 0u), end = neighbourTexel(slot, (count + 3u) / 4u);
    return NeighbourTexels(fetchNeighbours(first), fetchNeighbours(first + NEIGHBOUR_BLOCK), first, end);
}

bool nextTexel(inout NeighbourTexels texels)
{
    texels.now += NEIGHBOUR_BLOCK;
    texels.slots = texels.next;
    texels.next = fetchNeighbours(texels.now + NEIGHBOUR_BLOCK);
    return texels.now < texels.end;
}

/// The nth solid neighbour.
uint fetchSolidNeighbour(uint slot, uint n)
{
    uint k = sim.fluidSlots - 1u - n;
    return fetchNeighbours(neighbourTexel(slot, k / 4u))[k % 4u];
}
