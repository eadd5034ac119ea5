// One thread a fast particle: finds the particles that it may touch, all around and further away than contact_find
// looks. Of two fast ones the one of lower rank finds the other.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/search/contact_search.glsl"
#include "sim/search/filter_window.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer fastParticles;
uniform samplerBuffer searchCentres;

/// By how much further a particle looks than others [m].
float reachOf(uint particle)
{
    return extraMargin(fetchSearchCentre(searchCentres, fetchRank(particle).mover));
}

/// @param r from the other to the own particle [m]. @param reach of the own one.
bool isContact(uint own, SortedParticle other, vec3 r, float reach)
{
    if (other.fast && fetchRank(other.particle).rank < fetchRank(own).rank) return false;
    float both = reach + (other.fast ? reachOf(other.particle) : 0.0);
    return length(r) < sim.contactReach + both && mayTouch(own, other.particle) &&
           speaks(own, other.particle, r, both);
}

#define ROWS 25   // of cells; looked up one after another before any of their particles is handled

/// The particles of a row in one block of 32: first and end.
uvec2 blockOf(ivec3 cell, int row, uint block)
{
    uvec2 cells = farCells(cell, row);
    uint first = texelFetch(cellStarts, int(cells.x)).x + 32u * block, end = texelFetch(cellStarts, int(cells.y)).x;
    return uvec2(first, max(first, end));
}

/// Which of the first 32 particles of a range are nearer than `farthest` to x and outside a window, as bits.
uint hitsIn(uvec2 range, vec3 x, float farthest, FilterWindow window)
{
    uint hits = 0u, n = min(range.y - range.x, 32u);
    for (uint b = 0u; b < n; ++b) {
        SortedPosition there = fetchSortedPosition(range.x + b);
        vec3 r = x - there.position;
        hits |= (dot(r, r) < farthest * farthest && !isIn(window, there.mover) ? 1u : 0u) << b;
    }
    return hits;
}

/// What a fast particle knows of itself.
struct Seeker {
    uint particle;
    vec3 position;       // [m]
    ivec3 cell;
    float reach;         // reachOf()
    FilterWindow window;
};

/// Notes the contacts in one block of the rows from `start` on. @returns whether any row has more.
bool findIn(Seeker own, int start, uint block, inout uint count)
{
    float farthest = sim.contactReach + own.reach + sim.farReach;
    uint hits[ROWS], rows = 0u;   // of each row; the rows with hits, since these are few
    bool more = false;
    for (int row = 0; row < ROWS; ++row) {
        uvec2 range = blockOf(own.cell, start + row, block);
        hits[row] = hitsIn(range, own.position, farthest, own.window);
        rows |= (hits[row] != 0u ? 1u : 0u) << row;
        more = more || range.y - range.x > 32u;
    }
    while (rows != 0u) {
        int row = findLSB(rows);
        uint word = hits[row], m = blockOf(own.cell, start + row, block).x + uint(findLSB(word));
        hits[row] = word & (word - 1u);
        rows &= hits[row] == 0u ? rows - 1u : ~0u;
        SortedParticle other = fetchSortedParticle(m);
        vec3 place = fetchSortedPosition(m).position;
        if (inFarRange(own.cell, start + row, place) && isContact(own.particle, other, own.position - place, own.reach))
            notePair(own.particle, other.particle, count++);
    }
    return more;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= counters[0].fastListed) return;
    FastParticle fast = unpackFastParticle(texelFetch(fastParticles, int(k)).x);
    vec3 position = texelFetch(searchPositions, int(fast.particle)).xyz;
    FilterWindow window = windowAround(sortedMover(fetchRank(fast.particle).mover, fast.told));
    Seeker own = Seeker(fast.particle, position, cellOf(position), reachOf(fast.particle), window);
    uint count = 0u;
    for (int row = 0; row < FAR_RANGES; row += ROWS)
        for (uint block = 0u; findIn(own, row, block, count);) ++block;
    noteCount(own.particle, count);
}
