// Bits of cells near solid particles, and how far fluids look there. SOLIDS: of a world that has any.
#ifdef SOLIDS
uniform usamplerBuffer fluidNearSolids;
#endif

/// Which word of fluidNearSolids, and which bit of it.
uvec2 nearSolidsBit(uint cell)
{
    uint group = cell / CELLS_ALONG;
    return uvec2(group / 32u, 1u << (group & 31u));
}

/// How far particles around are looked for, squared, in cells: among themselves fluids do not reach as far.
float reachOf(vec3 at)
{
#ifdef SOLIDS
    uvec2 place = nearSolidsBit(cellIndex(ivec3(floor(at))));
    if ((texelFetch(fluidNearSolids, int(place.x)).x & place.y) != 0u) return 1.0;
#endif
    float reach = sim.fluidReach * sim.inverseFluidCell;
    return reach * reach;
}
