// One thread a fast particle: the particles that it may touch, all around and further than contact_find looks. Of two
// fast ones the one of lower rank finds the other.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/search/contact_search.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer fastParticles;
uniform samplerBuffer searchPositions;
uniform samplerBuffer searchCentres;

/// By how much further a particle looks than others.
float reachOf(uint particle)
{
    return extraMargin(fetchSearchCentre(searchCentres, fetchRank(particle).mover));
}

/// @param r from the other to the own particle [m]. @param reach of the own one.
bool isContact(SortedInfo own, SortedInfo other, vec3 r, float reach)
{
    if (other.fast && other.rank < own.rank) return false;
    float both = reach + (other.fast ? reachOf(other.particle) : 0.0);
    if (length(r) >= sim.contactReach + both) return false;
    if (other.assembly == own.assembly && !mayTouch(own.particle, other.particle)) return false;
    return speaks(own.particle, other.particle, r, both);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= counters[0].fastListed) return;
    FastParticle fast = unpackFastParticle(texelFetch(fastParticles, int(k)).x);
    uint i = fast.particle, mover = sortedMover(fetchRank(i).mover, fast.told);
    SortedInfo own = SortedInfo(i, fetchParticle(i).assembly, fetchRank(i).rank, true);
    vec3 x = texelFetch(searchPositions, int(i)).xyz;
    float reach = reachOf(i), farthest = sim.contactReach + reach + sim.farReach;
    ivec3 cell = cellOf(x);
    uint count = 0u;
    for (int range = 0; range < FAR_RANGES; ++range) {
        uvec2 cells = farCells(cell, range);
        uint end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint first = texelFetch(cellStarts, int(cells.x)).x; first < end; first += 32u) {
            // Bits first, branch-free; the few hits are visited afterwards.
            uint hits = 0u, n = min(end - first, 32u);
            for (uint b = 0u; b < n; ++b) {
                SortedPosition there = fetchSortedPosition(first + b);
                vec3 r = x - there.position;
                hits |= (there.mover != mover && dot(r, r) < farthest * farthest ? 1u : 0u) << b;
            }
            while (hits != 0u) {
                uint m = first + uint(findLSB(hits));
                hits &= hits - 1u;
                SortedInfo other = fetchSortedInfo(m);
                vec3 place = fetchSortedPosition(m).position;
                if (inFarRange(cell, range, place) && isContact(own, other, x - place, reach))
                    notePair(own, other, count++);
            }
        }
    }
    noteCount(own, count);
}
