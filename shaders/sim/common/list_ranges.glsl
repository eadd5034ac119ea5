// Reading the lists of contacts.
#include "sim/common/contact_lists.glsl"

uniform usamplerBuffer listStarts;

uint listEntry(uint parity, uint place)
{
    return texelFetch(listStarts, int(listStart(parity, place))).x;
}

/// The entries of `count` ranks from `rank` on: first and end.
uvec2 listRange(uint parity, uint list, uint rank, uint count)
{
    uint place = listPlace(list, rank);
    uint before = list == LIST_AS_FIRST ? 0u : listEntry(parity, listPlace(list, 0u));
    uint capacity = list == LIST_AS_FIRST    ? sim.pairCapacity
                    : list == LIST_AS_SECOND ? sim.contactSlots * sim.particleCount
                                             : sim.colliderPairCapacity;
    return min(uvec2(listEntry(parity, place), listEntry(parity, place + count)) - before, uvec2(capacity));
}

/// How many entries a list has, which may be more than there is room for.
uint listTotal(uint parity, uint list)
{
    return listEntry(parity, listPlace(list + 1u, 0u)) - listEntry(parity, listPlace(list, 0u));
}

/// From b to a, for two points at most a rounding error apart: up for the first, down for the second.
vec3 contactNormal(vec3 difference, float distance, bool first)
{
    return distance > 1e-7 ? difference / distance : vec3(0, first ? 1.0 : -1.0, 0);
}
