// One thread a particle, in cell order: the particles ahead of it that it may touch (paper, section 3.1: nearer than
// 1.2 diameters). Never particles of a body of its own, nor of its assembly where they overlap at rest; fast ones are
// found by contact_find_far, for which the first thread sets how many work groups it takes.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/common/groups.glsl"
#include "sim/search/contact_search.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uvec4, Dispatches, dispatches);

/// The particles ahead, range after range, as one sequence: long loops over all leave fewer lanes of a software driver
/// idle than a loop for each range.
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

/// The index in the sorted arrays of the sequence's particle c; `range` is which range it is of.
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

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.particleCount) return;
    if (k == 0u) dispatches[DISPATCH_FAST] = uvec4(groups(counters[0].fastListed), 1, 1, 0);
    SortedInfo info = fetchSortedInfo(k);
    if (info.fast) return;
    SortedPosition own = fetchSortedPosition(k);
    ivec3 cell = cellOf(own.position);
    Sequence ahead = sequenceAhead(cell, k);
    float reach = sim.contactReach * sim.contactReach;
    uint count = 0u;
    int range;
    for (uint first = 0u; first < ahead.count; first += 32u) {
        // Bits first, branch-free; the few hits are visited afterwards.
        uint hits = 0u;
        uint n = min(ahead.count - first, 32u);
        for (uint b = 0u; b < n; ++b) {
            SortedPosition other = fetchSortedPosition(indexOf(ahead, first + b, range));
            vec3 r = own.position - other.position;
            uint hit = dot(r, r) < reach && other.mover != own.mover ? 1u : 0u;
            hits |= hit << b;
        }
        while (hits != 0u) {
            uint m = indexOf(ahead, first + uint(findLSB(hits)), range);
            hits &= hits - 1u;
            SortedInfo other = fetchSortedInfo(m);
            if (other.fast || (other.assembly == info.assembly && !mayTouch(info.particle, other.particle))) continue;
            vec3 place = fetchSortedPosition(m).position;
            if (!inForwardRange(cell, range, place)) continue;
            if (!speaks(info.particle, other.particle, own.position - place, 0.0)) continue;
            notePair(info, other, count++);
        }
    }
    noteCount(info, count);
}
