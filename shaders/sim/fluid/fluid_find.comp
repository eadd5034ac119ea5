// One thread a slot: finds the neighbours between which fluids act. Solid particles list fluid ones only. The grid and
// packed positions both wrap: if fluid has spread wider than the grid, lists contain some particles that only look
// near, which have no effect. SOLIDS: of a world that has any.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/near_solids.glsl"
#include "sim/fluid/neighbour_search.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSearchPositions;
BUFFER(uvec2, SlotCounts, newSlotCounts);
UINT_TEXELS(newSlotNeighbours)
BUFFER(Counters, CountersBlock, counters);

/// Lists the fluid neighbours of a batch, from the front of the list on. @param counts  Numbers listed so far.
/// @param four  The last four listed, with the slot itself where there are fewer.
void listFluids(uint k, uint slots, inout NeighbourCounts counts, inout uvec4 four)
{
    uint ranges = 0u, held = counts.fluids & 3u;
    for (int range = 0; range < AROUND_RANGES; ++range) ranges |= fluids[range] != 0u ? 1u << range : 0u;
    int range = max(findLSB(ranges), 0);
    uint bits = fluids[range], first = firsts[range];
    bool fits = (counts.fluids & ~3u) + 4u + counts.solids <= sim.fluidSlots;
    do {
        uint texel = neighbourTexel(k, counts.fluids / 4u);
        for (uint c = 0u; c < 4u; ++c) {
            if (c < held || ranges == 0u || !fits) continue;
            uint index = first + uint(findLSB(bits));
            four[c] = index < slots ? index : index - slots;
            ++counts.fluids;
            bits &= bits - 1u;
            if (bits != 0u) continue;
            ranges &= ranges - 1u;
            range = max(findLSB(ranges), 0);
            bits = fluids[range];
            first = firsts[range];
        }
        if (fits) imageStore(newSlotNeighbours, int(texel), four);
        if ((counts.fluids & 3u) == 0u) four = uvec4(k);
        held = 0u;
        fits = (counts.fluids & ~3u) + 4u + counts.solids <= sim.fluidSlots;
    } while (ranges != 0u && fits);
}

/// Lists the solid neighbours of a batch, from the end of the list on. @param four  The last four listed.
void listSolids(uint k, uint slots, inout NeighbourCounts counts, inout uvec4 four)
{
    uint ranges = 0u;
    for (int range = 0; range < AROUND_RANGES; ++range) ranges |= solids[range] != 0u ? 1u << range : 0u;
    while (ranges != 0u && paddedCount(counts.fluids) + counts.solids < sim.fluidSlots) {
        int range = findLSB(ranges);
        uint bits = solids[range], index = firsts[range] + uint(findLSB(bits)), n = sim.fluidSlots - ++counts.solids;
        four[n % 4u] = index < slots ? index : index - slots;
        imageStore(newSlotNeighbours, int(neighbourTexel(k, n / 4u)), four);
        solids[range] = bits & bits - 1u;
        if (solids[range] == 0u) ranges &= ranges - 1u;
    }
}

void main()
{
    uint k = gl_GlobalInvocationID.x, slots = gridMembers();
    if (k >= slots) return;
    vec3 at = texelFetch(fluidSearchPositions, int(fetchSlotParticle(k))).xyz * inverseGridCell();
    Seeker seeker = seekerAt(texelFetch(fluidSorted, int(k / 4u))[k % 4u]);
    NeighbourCounts counts = NeighbourCounts(0u, 0u);
    uvec4 four = uvec4(k), fourSolids = uvec4(k);
    float within = reachOf(at);
    uint wanted = 0u, batch = 0u;
    bool more;
    do {
        wanted += findBatch(seeker, at, within, k, slots, batch, more);
        listFluids(k, slots, counts, four);
#ifdef SOLIDS
        listSolids(k, slots, counts, fourSolids);
#endif
        batch += 32u;
    } while (more);
    if (wanted > counts.fluids + counts.solids) {
        atomicOr(counters[0].problems, PROBLEM_FLUID);
        atomicMax(counters[0].wantedNeighbours, wanted + 3u);
    }
    newSlotCounts[k] = pack(counts);
}
