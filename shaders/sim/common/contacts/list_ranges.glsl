// Reading the lists of contacts.
#include "sim/common/contacts/contact_lists.glsl"

uniform usamplerBuffer listStarts;

uint listEntry(uint parity, uint index)
{
    return texelFetch(listStarts, int(listStart(parity, index))).x;
}

/// The entries of `count` ranks from `rank` on: first and end.
uvec2 listRange(uint parity, uint list, uint rank, uint count)
{
    uint index = listIndex(list, rank);
    uint before = list == LIST_AS_FIRST ? 0u : listEntry(parity, listIndex(list, 0u));
    uint capacity = list == LIST_AS_FIRST    ? sim.pairCapacity
                    : list == LIST_AS_SECOND ? sim.candidateCapacity
                                             : sim.colliderPairCapacity;
    return min(uvec2(listEntry(parity, index), listEntry(parity, index + count)) - before, uvec2(capacity));
}

/// The number of a list's entries, which may exceed its capacity.
uint listTotal(uint parity, uint list)
{
    return listEntry(parity, listIndex(list + 1u, 0u)) - listEntry(parity, listIndex(list, 0u));
}
