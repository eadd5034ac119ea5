// One thread a slot: the neighbours between which fluids act. Solid particles list fluid ones only.
#include "shared/kernel.glsl"
#include "shared/fluid_grid.glsl"
#include "shared/grid.glsl"
#include "shared/neighbour_lists.glsl"
#include "shared/packed_places.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidFoundPositions;
uniform usamplerBuffer slotParticles;
uniform usamplerBuffer fluidSorted;      // packed, four in a texel
uniform usamplerBuffer cellStarts;
BUFFER(uvec2, SlotCounts, slotCounts);
BUFFER(uint, SlotNeighbours, slotNeighbours);
BUFFER(Counters, CountersBlock, counters);

/// Of 32 candidates from `first`, a multiple of four, on, as bits: those that act on a place, and those that are solid.
struct Hits {
    uint near, solid;
};

struct Seeker {
    uvec3 fields;
    vec2 reach;     // squared, of fluid and of solid ones [quanta^2]
};

void look(inout Hits hits, Seeker seeker, uint code, uint bit)
{
    bool solid = (code & PACKED_SOLID) != 0u;
    float square = packedSquare(seeker.fields, packedFields(code));
    hits.near |= square < (solid ? seeker.reach.y : seeker.reach.x) ? bit : 0u;
    hits.solid |= solid ? bit : 0u;
}

Hits hitsFrom(Seeker seeker, uint first, uint end)
{
    Hits hits = Hits(0u, 0u);
    uint stop = min(end, first + 32u);
    for (uint m = first, bit = 1u; m < stop; m += 4u, bit <<= 4) {
        uvec4 four = texelFetch(fluidSorted, int(m / 4u));
        look(hits, seeker, four.x, bit);
        look(hits, seeker, four.y, bit << 1);
        look(hits, seeker, four.z, bit << 2);
        look(hits, seeker, four.w, bit << 3);
    }
    if (end - first < 32u) hits.near &= (1u << (end - first)) - 1u;
    return hits;
}

/// What acts on a solid is fluid. Fluid particles act on each other up to the kernel's reach.
Seeker seekerAt(uint code)
{
    vec2 reach = step.inverseFluidCell * QUANTA_PER_CELL * vec2(step.fluidReach, step.fluidListReach) + 2.0;
    bool solid = (code & PACKED_SOLID) != 0u;
    return Seeker(packedFields(code), solid ? vec2(reach.y * reach.y, -1.0) : reach * reach);
}

/// Fluid neighbours take whole texels.
bool room(uvec2 counts)
{
    return (counts.x + 3u & ~3u) + counts.y <= step.fluidSlots;
}

void list(uint k, uint place, uint slot)
{
    slotNeighbours[4u * neighbourTexel(k, place / 4u) + place % 4u] = slot;
}

void main()
{
    uint k = gl_GlobalInvocationID.x, slots = gridMembers();
    if (k >= slots) return;
    ivec3 cell = cellOf(texelFetch(fluidFoundPositions, int(texelFetch(slotParticles, int(k)).x)).xyz);
    Seeker seeker = seekerAt(texelFetch(fluidSorted, int(k / 4u))[k % 4u]);
    uvec2 counts = uvec2(0);
    uint wanted = 0u;
    for (int range = 0; range < AROUND_RANGES; ++range) {
        uvec2 cells = aroundCells(cell, range);
        uint start = texelFetch(cellStarts, int(cells.x)).x, end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint first = start & ~3u; first < end; first += 32u) {
            Hits hits = hitsFrom(seeker, first, end);
            if (first < start) hits.near &= ~0u << (start - first);
            while (hits.near != 0u) {
                uint bit = uint(findLSB(hits.near)), place = first + bit;
                hits.near &= hits.near - 1u;
                // Behind the last slot the first ones stand again.
                uint slot = place < slots ? place : place - slots;
                if (slot == k) continue;
                uint particle = texelFetch(slotParticles, int(slot)).x;
                vec3 there = texelFetch(fluidFoundPositions, int(particle)).xyz;
                // The grid and packed places both wrap: what looks near may be a lattice's width away.
                if (!standsAround(cell, range, there)) continue;
                bool solid = (hits.solid >> bit & 1u) != 0u;
                uvec2 more = counts + (solid ? uvec2(0, 1) : uvec2(1, 0));
                ++wanted;
                if (room(more)) {
                    list(k, solid ? step.fluidSlots - more.y : counts.x, slot);
                    counts = more;
                }
            }
        }
    }
    if (wanted > counts.x + counts.y) {
        atomicOr(counters[0].problems, PROBLEM_FLUID);
        atomicMax(counters[0].wantedNeighbours, wanted + 3u);
    }
    for (uint n = counts.x; n % 4u != 0u; ++n) list(k, n, k);
    slotCounts[k] = counts;
}
