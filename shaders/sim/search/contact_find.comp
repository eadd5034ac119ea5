// One thread a particle, in cell order: finds the particles ahead of it that it may touch (paper, section 3.1: nearer
// than 1.2 diameters), none of its own body, and of its assembly none that overlaps it at rest. contact_find_far serves
// fast particles; the first thread sets its number of work groups.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/common/groups.glsl"
#include "sim/search/contact_search.glsl"
#include "sim/search/filter_window.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uvec4, Dispatches, dispatches);

/// The particles ahead, range after range, as one sequence: long loops over all of them leave fewer lanes of a software
/// driver idle than a loop for each range.
struct Sequence {
    uint begins[FORWARD_RANGES];    // index of a range's first particle in the sequence
    uint offsets[FORWARD_RANGES];   // from there to its index in the sorted arrays
    uint count;
};

Sequence sequenceAhead(ivec3 cell, uint k)
{
    Sequence s;
    s.count = 0u;
    for (int range = 0; range < FORWARD_RANGES; ++range) {
        uvec2 cells = forwardCells(cell, range);
        uint first = range == 0 ? k + 1u : texelFetch(cellStarts, int(cells.x)).x;
        s.begins[range] = s.count;
        s.offsets[range] = first - s.count;
        s.count += texelFetch(cellStarts, int(cells.y)).x - first;
    }
    return s;
}

/// The index in the sorted arrays of the sequence's particle c, and its range.
uint indexOf(Sequence s, uint c, out int range)
{
    uint offset = s.offsets[0];
    range = 0;
    for (int r = 1; r < FORWARD_RANGES; ++r)
        if (c >= s.begins[r]) {
            offset = s.offsets[r];
            range = r;
        }
    return c + offset;
}

/// Bits of those of the 32 particles from the sequence's `first` on that are nearer than sim.contactReach and outside a
/// window: branch-free, the few hits are visited afterwards.
uint hitsFrom(Sequence s, uint first, vec3 position, FilterWindow window)
{
    uint hits = 0u, n = min(s.count - min(s.count, first), 32u);
    int range;
    for (uint b = 0u; b < n; ++b) {
        SortedPosition other = fetchSortedPosition(indexOf(s, first + b, range));
        vec3 r = position - other.position;
        bool isNear = dot(r, r) < sim.contactReach * sim.contactReach;
        hits |= (isNear && !isIn(window, other.mover) ? 1u : 0u) << b;
    }
    return hits;
}

/// Clears the first of 64 bits that is set. @returns its index.
uint takeFirst(inout uvec2 bits)
{
    bool low = bits.x != 0u;
    uint word = low ? bits.x : bits.y, left = word & (word - 1u);
    bits = low ? uvec2(left, bits.y) : uvec2(0u, left);
    return (low ? 0u : 32u) + uint(findLSB(word));
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.particleCount) return;
    if (k == 0u) dispatches[DISPATCH_FAST] = uvec4(groups(counters[0].fastListed), 1, 1, 0);
    SortedParticle self = fetchSortedParticle(k);
    if (self.fast) return;
    SortedPosition own = fetchSortedPosition(k);
    ivec3 cell = cellOf(own.position);
    Sequence ahead = sequenceAhead(cell, k);
    FilterWindow window = windowAround(own.mover);
    uint count = 0u, first = 0u;
    do {
        uvec2 hits;
        for (uint w = 0u; w < 2u; ++w) hits[w] = hitsFrom(ahead, first + 32u * w, own.position, window);
        while (hits != uvec2(0)) {
            int range;
            uint m = indexOf(ahead, first + takeFirst(hits), range);
            SortedParticle other = fetchSortedParticle(m);
            vec3 place = fetchSortedPosition(m).position;
            if (other.fast || !inForwardRange(cell, range, place)) continue;
            if (!mayTouch(self.particle, other.particle)) continue;
            if (speaks(self.particle, other.particle, own.position - place, 0.0))
                notePair(self.particle, other.particle, count++);
        }
    } while ((first += 64u) < ahead.count);
    noteCount(self.particle, count);
}
