// Candidates for the neighbours of a slot, from the rows of cells around it in batches of 32, and the test whether they
// are near enough.
#include "sim/fluid/packed_positions.glsl"

uniform usamplerBuffer fluidSorted;      // packed positions by slot, four in a texel
uniform usamplerBuffer cellStarts;

/// The slot whose neighbours are looked for.
struct Seeker {
    uvec3 coordinates;
    vec2 reach;     // squared, of fluid and of solid particles, as packedSquare() has it
};

/// Only fluid acts on a solid. Fluid particles act on each other up to the kernel's reach.
Seeker seekerAt(uint code)
{
    vec2 reach = sim.inverseFluidCell * QUANTA_PER_CELL * vec2(sim.fluidReach, sim.fluidListReach) + 2.0;
    reach *= PACKED_QUANTUM;
    bool solid = (code & PACKED_SOLID) != 0u;
    return Seeker(packedCoordinates(code), solid ? vec2(reach.y * reach.y, -1.0) : reach * reach);
}

/// Bits of 32 candidates from a multiple of four on: those near enough, and those that are solid.
struct Hits {
    uint near, solid;
};

void look(inout Hits hits, Seeker seeker, uint code, uint bit)
{
    bool solid = (code & PACKED_SOLID) != 0u;
    float square = packedSquare(seeker.coordinates, packedCoordinates(code));
    hits.near |= square < (solid ? seeker.reach.y : seeker.reach.x) ? bit : 0u;
    hits.solid |= solid ? bit : 0u;
}

/// @param range  Candidates from range.x up to range.y
Hits hitsFrom(Seeker seeker, uint first, uvec2 range)
{
    Hits hits = Hits(0u, 0u);
    uint stop = min(range.y, first + 32u);
    uint m = first, bit = 1u;
    do {
        uvec4 four = texelFetch(fluidSorted, int(m / 4u));
        look(hits, seeker, four.x, bit);
        look(hits, seeker, four.y, bit << 1);
        look(hits, seeker, four.z, bit << 2);
        look(hits, seeker, four.w, bit << 3);
        m += 4u, bit <<= 4;
    } while (m < stop);
    if (first < range.x) hits.near &= ~0u << (range.x - first);
    if (range.y < first + 32u) hits.near &= range.y > first ? (1u << (range.y - first)) - 1u : 0u;
    return hits;
}

/// The candidates of a row of cells beside a position that come near enough: first and end.
/// @param at  The position, in cells  @param within  How near, squared, in cells
uvec2 rowNear(vec3 at, float within, int range)
{
    vec2 side = vec2(range % 3, range / 3) - 1.0;
    vec2 gaps = 0.5 * abs(side) + side * (0.5 - fract(at.yz));
    float square = within + 0.001 - dot(gaps, gaps), ahead = float(CELLS_ALONG) * sqrt(max(square, 0.0));
    ivec2 ends = ivec2(floor(at.x + vec2(-ahead, ahead)));
    uint first = cellIndex(ivec3(ends.x, ivec2(floor(at.yz) + side)));
    return uvec2(first, first + (square > 0.0 ? uint(ends.y - ends.x + 1) : 0u));
}

// The batch: for each row, the index of its first candidate, and bits of those that are neighbours. Global, so that all
// lanes of a vector can list their next hit in the same round, whatever row it is in.
uint firsts[AROUND_RANGES], fluids[AROUND_RANGES], solids[AROUND_RANGES];

/// The candidates from `batch` on of all rows around slot k.
/// @param within  As rowNear() has it  @param more  Whether more candidates follow.
/// @returns how many of these are neighbours.
uint findBatch(Seeker seeker, vec3 at, float within, uint k, uint slots, uint batch, out bool more)
{
    uint found = 0u;
    more = false;
    for (int range = 0; range < AROUND_RANGES; ++range) {
        uvec2 cells = rowNear(at, within, range);
        uvec2 ends = uvec2(texelFetch(cellStarts, int(cells.x)).x, texelFetch(cellStarts, int(cells.y)).x);
        uint first = (ends.x & ~3u) + batch;
        Hits hits = hitsFrom(seeker, first, ends);
        // Excludes the slot itself, which has two indices: after the last slot the first ones are listed again.
        uvec2 own = uvec2(k, k + slots) - first;
        hits.near &= ~((own.x < 32u ? 1u << own.x : 0u) | (own.y < 32u ? 1u << own.y : 0u));
        firsts[range] = first;
        fluids[range] = hits.near & ~hits.solid;
        solids[range] = hits.near & hits.solid;
        found += uint(bitCount(hits.near));
        more = more || first + 32u < ends.y;
    }
    return found;
}
