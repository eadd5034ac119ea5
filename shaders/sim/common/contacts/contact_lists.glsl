// The lists of contacts. A contact between particles is a pair, listed with its first particle: particles by rank (by
// body, then by id), so that a body's pairs stand together. A list of references leads from its second particle to the
// pair; a reference is NONE if there was no room for the pair.
// Contacts with colliders are a third list. listStarts has where the entries of each rank begin, for the three lists
// one after another; the two halves of all lists alternate, so that a new search finds the old impulses.

#define LIST_AS_FIRST 0u
#define LIST_AS_SECOND 1u
#define LIST_COLLIDERS 2u

/// Where listCounts has the count of a rank in one of the lists.
uint listIndex(uint list, uint rank)
{
    return list * sim.particleCount + rank;
}

/// Where listStarts has the first entry of a rank's list; the next entry is the end.
uint listStart(uint parity, uint index)
{
    return parity * (3u * sim.particleCount + 1u) + index;
}
