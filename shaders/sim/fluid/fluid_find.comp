// One thread a slot: the neighbours between which fluids act. Solid particles list fluid ones only. The grid and packed
// places both wrap: where fluid has spread wider than the grid, lists hold some that only look near, which do nothing.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_grid.glsl"
#include "sim/common/grid.glsl"
#include "sim/fluid/neighbour_lists.glsl"
#include "sim/fluid/packed_positions.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSearchPositions;
uniform usamplerBuffer slotParticles;
uniform usamplerBuffer fluidSorted;      // packed, four in a texel
uniform usamplerBuffer cellStarts;
BUFFER(uvec2, SlotCounts, slotCounts);
BUFFER(uvec4, SlotNeighbours, slotNeighbours);
BUFFER(Counters, CountersBlock, counters);

struct Seeker {
    uvec3 fields;
    vec2 reach;     // squared, of fluid and of solid ones [quanta^2]
};

/// What acts on a solid is fluid. Fluid particles act on each other up to the kernel's reach.
Seeker seekerAt(uint code)
{
    vec2 reach = sim.inverseFluidCell * QUANTA_PER_CELL * vec2(sim.fluidReach, sim.fluidListReach) + 2.0;
    bool solid = (code & PACKED_SOLID) != 0u;
    return Seeker(packedFields(code), solid ? vec2(reach.y * reach.y, -1.0) : reach * reach);
}

/// Of 32 candidates from a multiple of four on, as bits: those that act on a place, and those that are solid.
struct Hits {
    uint near, solid;
};

void look(inout Hits hits, Seeker seeker, uint code, uint bit)
{
    bool solid = (code & PACKED_SOLID) != 0u;
    float square = packedSquare(seeker.fields, packedFields(code));
    hits.near |= square < (solid ? seeker.reach.y : seeker.reach.x) ? bit : 0u;
    hits.solid |= solid ? bit : 0u;
}

/// @param range  Candidates from range.x up to range.y
Hits hitsFrom(Seeker seeker, uint first, uvec2 range)
{
    Hits hits = Hits(0u, 0u);
    uint stop = min(range.y, first + 32u);
    for (uint m = first, bit = 1u; m < stop; m += 4u, bit <<= 4) {
        uvec4 four = texelFetch(fluidSorted, int(m / 4u));
        look(hits, seeker, four.x, bit);
        look(hits, seeker, four.y, bit << 1);
        look(hits, seeker, four.z, bit << 2);
        look(hits, seeker, four.w, bit << 3);
    }
    if (first < range.x) hits.near &= ~0u << (range.x - first);
    if (range.y < first + 32u) hits.near &= range.y > first ? (1u << (range.y - first)) - 1u : 0u;
    return hits;
}

// Of each range 32 candidates: the place of the first, and as bits those that act. All lanes list their next hit in the
// same round, whatever range it is of.
uint firsts[AROUND_RANGES], fluids[AROUND_RANGES], solids[AROUND_RANGES];

/// Of a row of cells beside a place those that come near enough: first, and behind the last.
/// @param at  The place, in cells
uvec2 rowNear(vec3 at, int range)
{
    vec2 side = vec2(range % 3, range / 3) - 1.0;
    vec2 gaps = 0.5 * abs(side) + side * (0.5 - fract(at.yz));
    float square = 1.001 - dot(gaps, gaps), ahead = float(CELLS_ALONG) * sqrt(max(square, 0.0));
    ivec2 ends = ivec2(floor(at.x + vec2(-ahead, ahead)));
    uint first = cellIndex(ivec3(ends.x, ivec2(floor(at.yz) + side)));
    return uvec2(first, first + (square > 0.0 ? uint(ends.y - ends.x + 1) : 0u));
}

/// Candidates from `batch` on of all rows around slot k. Says how many of them act, and whether more follow.
uvec2 findBatch(Seeker seeker, vec3 at, uint k, uint slots, uint batch)
{
    uint found = 0u, more = 0u;
    for (int range = 0; range < AROUND_RANGES; ++range) {
        uvec2 cells = rowNear(at, range);
        uvec2 places = uvec2(texelFetch(cellStarts, int(cells.x)).x, texelFetch(cellStarts, int(cells.y)).x);
        uint first = (places.x & ~3u) + batch;
        Hits hits = hitsFrom(seeker, first, places);
        // Itself. Behind the last slot the first ones stand again.
        uvec2 own = uvec2(k, k + slots) - first;
        hits.near &= ~((own.x < 32u ? 1u << own.x : 0u) | (own.y < 32u ? 1u << own.y : 0u));
        firsts[range] = first;
        fluids[range] = hits.near & ~hits.solid;
        solids[range] = hits.near & hits.solid;
        found += uint(bitCount(hits.near));
        more |= first + 32u < places.y ? 1u : 0u;
    }
    return uvec2(found, more);
}

/// Lists the fluid hits of a batch. @param four  The last neighbours listed, and the slot itself where fewer are
void listFluids(uint k, uint slots, inout uvec2 counts, inout uvec4 four)
{
    uint ranges = 0u, held = counts.x & 3u;
    for (int range = 0; range < AROUND_RANGES; ++range) ranges |= fluids[range] != 0u ? 1u << range : 0u;
    int range = max(findLSB(ranges), 0);
    uint bits = fluids[range], first = firsts[range];
    while (ranges != 0u && (counts.x & ~3u) + 4u + counts.y <= sim.fluidSlots) {
        uint texel = neighbourTexel(k, counts.x / 4u);
        for (uint c = 0u; c < 4u; ++c) {
            if (c < held || ranges == 0u) continue;
            uint place = first + uint(findLSB(bits));
            four[c] = place < slots ? place : place - slots;
            ++counts.x;
            bits &= bits - 1u;
            if (bits != 0u) continue;
            ranges &= ranges - 1u;
            range = max(findLSB(ranges), 0);
            bits = fluids[range];
            first = firsts[range];
        }
        slotNeighbours[texel] = four;
        if ((counts.x & 3u) == 0u) four = uvec4(k);
        held = 0u;
    }
}

/// The solid hits, from the end of the list on.
void listSolids(uint k, uint slots, inout uvec2 counts)
{
    for (int range = 0; range < AROUND_RANGES; ++range)
        for (uint bits = solids[range]; bits != 0u; bits &= bits - 1u) {
            if ((counts.x + 3u & ~3u) + counts.y >= sim.fluidSlots) return;
            uint place = firsts[range] + uint(findLSB(bits)), n = sim.fluidSlots - ++counts.y;
            slotNeighbours[neighbourTexel(k, n / 4u)][n % 4u] = place < slots ? place : place - slots;
        }
}

void main()
{
    uint k = gl_GlobalInvocationID.x, slots = gridMembers();
    if (k >= slots) return;
    vec3 at = texelFetch(fluidSearchPositions, int(texelFetch(slotParticles, int(k)).x)).xyz * inverseGridCell();
    Seeker seeker = seekerAt(texelFetch(fluidSorted, int(k / 4u))[k % 4u]);
    uvec2 counts = uvec2(0), found = uvec2(0, 1);
    uvec4 four = uvec4(k);
    uint wanted = 0u;
    for (uint batch = 0u; found.y != 0u; batch += 32u) {
        found = findBatch(seeker, at, k, slots, batch);
        wanted += found.x;
        listFluids(k, slots, counts, four);
        listSolids(k, slots, counts);
    }
    if (wanted > counts.x + counts.y) {
        atomicOr(counters[0].problems, PROBLEM_FLUID);
        atomicMax(counters[0].wantedNeighbours, wanted + 3u);
    }
    slotCounts[k] = counts;
}
