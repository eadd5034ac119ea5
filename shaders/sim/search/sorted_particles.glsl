// Data of particles for the search, in the order of cells.

/// As in sortedPositions.
struct SortedPosition {
    vec3 position;   // the one for which contacts are found [m]
    uint mover;      // sortedMover(), only to be compared with another's
};

SortedPosition unpackSortedPosition(vec4 t)
{
    return SortedPosition(t.xyz, floatBitsToUint(t.w));
}

// The mover's index is stored as a float's bits, with an offset: a GPU may flush the denormals that small indices would
// be. It stays below the NaNs.
// All movers that are told where to be share one name, so that none of them finds another.
uint sortedMover(uint mover, bool told)
{
    return 0x01000000u + (told ? sim.moverCount : mover);
}

vec4 packSortedPosition(SortedPosition sorted)
{
    return vec4(sorted.position, uintBitsToFloat(sorted.mover));
}

/// As in fastParticles: one that looks further for contacts.
struct FastParticle {
    uint particle;
    bool told;       // isTold()
};

FastParticle unpackFastParticle(uint t)
{
    return FastParticle(t >> 1, (t & 1u) != 0u);
}

uint packFastParticle(FastParticle fast)
{
    return fast.particle << 1 | (fast.told ? 1u : 0u);
}

/// As in sortedParticles.
struct SortedParticle {
    uint particle;
    bool fast;       // it looks further for contacts: contact_find_far finds them
};

SortedParticle unpackSortedParticle(uint t)
{
    return SortedParticle(t >> 1, (t & 1u) != 0u);
}

uint packSortedParticle(SortedParticle sorted)
{
    return sorted.particle << 1 | (sorted.fast ? 1u : 0u);
}
