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

bool isContact(SortedInfo own, SortedInfo other, float apart, float reach)
{
    if (other.fast && other.rank < own.rank) return false;
    float both = reach + (other.fast ? reachOf(other.particle) : 0.0);
    if (apart >= sim.contactReach + both) return false;
    return other.assembly != own.assembly || mayTouch(own.particle, other.particle);
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
        for (uint m = texelFetch(cellStarts, int(cells.x)).x; m < end; ++m) {
            SortedPosition there = fetchSortedPosition(m);
            vec3 y = there.position;
            float apart = length(x - y);
            if (there.mover == mover || apart >= farthest || !inFarRange(cell, range, y)) continue;
            SortedInfo other = fetchSortedInfo(m);
            float further = reach + (other.fast ? reachOf(other.particle) : 0.0);
            if (isContact(own, other, apart, reach) && speaks(i, other.particle, x - y, further))
                notePair(own, other, count++);
        }
    }
    noteCount(own, count);
}
