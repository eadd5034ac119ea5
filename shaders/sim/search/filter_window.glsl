// Most particles near another belong to its mover or to one that it never touches (Body::filtered). A window recognizes
// them by their movers alone.
#include "sim/search/sorted_particles.glsl"

/// 32 movers from `first` on, in names as of sortedMover(): those with a bit never touch a particle.
struct FilterWindow {
    uint first, bits;
};

bool isIn(FilterWindow window, uint name)
{
    uint k = name - window.first;
    return k < 32u && (window.bits >> (k & 31u) & 1u) != 0u;
}

#ifdef FILTERS
#include "sim/search/filter_bits.glsl"

/// The mover itself and what it filters of the 32 bodies of its object that share a word of filterBits with it.
FilterWindow windowAround(uint name)
{
    uint mover = name - sortedMover(0u, false);
    BodyFilters filters = fetchBodyFilters(min(mover, sim.bodyCount - 1u));
    uint k = mover - filters.firstBody, word = k & ~31u;
    if (mover >= filters.endBody || mover < filters.firstBody) return FilterWindow(name, 1u);
    return FilterWindow(name - (k & 31u), filterBits[(filters.firstBit + word) >> 5] | 1u << (k & 31u));
}
#else
FilterWindow windowAround(uint name)
{
    return FilterWindow(name, 1u);
}
#endif
